#include <gtest/gtest.h>
#include <string>
#include "worlds.h"
namespace drench { namespace {
std::unique_ptr<btSoftBody> level(btSoftBodyWorldInfo& info, const Fabric& f, double side, int nodes, double h) {
  return makeSheet(info, f, flatCorners({btScalar(-side/2), btScalar(h), btScalar(-side/2)}, {btScalar(side),0,0}, {0,0,btScalar(side)}), nodes, nodes);
}
SheetSettings noAir() { SheetSettings s; s.stepping = Stepping::byApplication; return s; }
double energy(const btSoftBody& s, const Fabric& f, double side, int n, double g) {
  double e=0; for (int i=0;i<s.m_nodes.size();++i) { double m=test::mass(s.m_nodes[i]); e += m*(0.5*double(s.m_nodes[i].m_v.length2()) + g*double(s.m_nodes[i].m_x.y())); }
  const double a=side/(n-1);
  auto X=[&](int i,int j)->btVector3 const&{ return s.m_nodes[i+n*j].m_x; };
  auto add=[&](const btVector3& p,const btVector3& q,double L,double k){ double d=double((p-q).length())-L; e+=0.5*k*d*d; };
  for (int j=0;j<n;++j) for (int i=0;i<n;++i) { double rs=(j==0||j==n-1)?.5:1, cs=(i==0||i==n-1)?.5:1;
    if (i+1<n) add(X(i,j),X(i+1,j),a,(f.stretchWarp-f.shear)*rs); if (j+1<n) add(X(i,j),X(i,j+1),a,(f.stretchWeft-f.shear)*cs);
    if (i+1<n&&j+1<n) { add(X(i,j),X(i+1,j+1),a*std::sqrt(2.),f.shear); add(X(i+1,j),X(i,j+1),a*std::sqrt(2.),f.shear);} }
  return e;
}
TEST(X, FreeFallNoAir) {
  for (double v0 : {0., 10.}) for (int steps : {1,4,20,60,100,400}) {
    test::SmallStepWorld rig({steps, 0.01});
    btSoftBody& s = rig.add(level(rig.info(), fabrics::cottonPlain(), 0.5, 17, 0));
    rig.cover(s, fabrics::cottonPlain(), noAir()); s.m_cfg.kDP=0;
    for (int i=0;i<s.m_nodes.size();++i) s.m_nodes[i].m_v.setValue(btScalar(0.3),btScalar(-v0),0);
    rig.run(1.0);
    btVector3 p(0,0,0), x(0,0,0); double m=0; for (int i=0;i<s.m_nodes.size();++i) { p+=s.m_nodes[i].m_v*btScalar(test::mass(s.m_nodes[i])); x+=s.m_nodes[i].m_x*btScalar(test::mass(s.m_nodes[i])); m+=test::mass(s.m_nodes[i]);} p/=btScalar(m); x/=btScalar(m);
    const double h=1./60/steps; 
    printf("v0 %g steps %d: vy err %.2e vx err %.2e vz %.2e  y err %.2e strain %.2e\n", v0, steps, double(p.y())+v0+9.81, double(p.x())-0.3, double(p.z()), double(x.y())+v0+0.5*9.81*(1+h), test::largestStrain(s));
  }
}
TEST(X, kDP) {
  for (double c : {1.,5.}) for (double dt : {1./30, 1./60, 1./240}) for (int steps : {1,20,60}) {
    test::SmallStepWorld rig({steps, 0.01}); rig.setGravity({0,0,0});
    btSoftBody& s = rig.add(level(rig.info(), fabrics::cottonPlain(), 0.5, 17, 0));
    rig.cover(s, fabrics::cottonPlain(), noAir()); s.m_cfg.kDP=btScalar(c);
    for (int i=0;i<s.m_nodes.size();++i) s.m_nodes[i].m_v.setValue(1,2,0);
    rig.run(1.0, dt);
    printf("c %g dt 1/%.0f steps %d: %.6f %.6f of %.6f\n", c, 1/dt, steps, double(s.m_nodes[100].m_v.x()), double(s.m_nodes[100].m_v.y()/2), std::exp(-c));
  }
}
TEST(X, Energy) {
  for (double k : {100., 2000.}) for (int n : {17,33}) for (int steps : {1, 4, 20, 0}) for (int bend : {0,1}) for (int every : {0,1}) {
    test::SmallStepWorld rig({steps, 0.01});
    Fabric f = fabrics::cottonPlain(); f.stretchWarp=f.stretchWeft=k; f.shear=std::min(60., .2*k); f.bending = bend? 1.16e-5:1e-9; f.bendingFriction=0; if (every) f.shear=5;
    btSoftBody& s = rig.add(level(rig.info(), f, 0.5, n, 0));
    s.m_nodes[0].m_im = s.m_nodes[n-1].m_im = 0;
    rig.cover(s, f, noAir()); s.m_cfg.kDP=0;
    const double e0=energy(s,f,0.5,n,9.81), span=0.15*0.25*9.81*0.25; double prev=e0, rise=0, top=e0; double e=e0, e1=0;
    for (int i=0;i<600;++i) { rig.run(1./60); e=energy(s,f,0.5,n,9.81); rise=std::max(rise,e-prev); top=std::max(top,e); prev=e; if (i==60) e1=e; }
    printf("k %g n %d steps %d bend %d soft shear %d: energy 0 -> 1 s %.4f -> 10 s %.4f of span; largest rise in a frame %.2e, above start %.2e  v %.3f\n", k, n, steps, bend, every, (e1-e0)/span, (e-e0)/span, rise/span, (top-e0)/span, double(s.m_nodes[n*n-1].m_v.length()));
  }
}
TEST(X, Pendulum) {
  for (int along : {0,1}) for (int steps : {1, 20, 80}) {
    test::SmallStepWorld rig({steps, 0.01});
    Fabric f = fabrics::cottonPlain(); f.bending=1e-9; f.bendingFriction=0; f.stretchWarp=f.stretchWeft=20000;
    const double L=0.5; const int n=33;
    auto b = along ? makeSheet(rig.info(), f, flatCorners({0,0,0},{btScalar(0.03125),0,0},{0,btScalar(-L),0}), 3, n) : makeSheet(rig.info(), f, flatCorners({0,0,0},{0,btScalar(-L),0},{btScalar(0.03125),0,0}), n, 3);
    btSoftBody& s=rig.add(std::move(b));
    for (int i=0;i<3;++i) s.m_nodes[along? i : i*n].m_im=0;
    rig.cover(s, f, noAir()); s.m_cfg.kDP=0;
    // first mode J0(2.4048 sqrt(y/L)), y from the free end
    for (int i=0;i<s.m_nodes.size();++i) { btVector3& x=s.m_nodes[i].m_x; double y=L+double(x.y()); x.setZ(btScalar(0.01*j0(2.404826*std::sqrt(y/L)))); }
    const int tip = along ? 1+3*(n-1) : n-1+n;
    std::vector<double> cross; double was=double(s.m_nodes[tip].m_x.z()); const double dt=1./60;
    for (int i=0;i<1200;++i) { rig.run(dt,dt); double z=double(s.m_nodes[tip].m_x.z()); if (was>0&&z<=0) cross.push_back((i+was/(was-z))*dt); was=z; }
    printf("along %d steps %d: crossings %zu period %.5f of %.5f, amplitude now %.4f\n", along, steps, cross.size(), cross.size()>1?(cross.back()-cross.front())/double(cross.size()-1):0, 2*M_PI/(1.202413*std::sqrt(9.81/L)), double(s.m_nodes[tip].m_x.z()));
  }
}
TEST(X, DryingInOneStep) {
  for (int n : {17,64}) for (int count : {1,4,20}) for (double dt : {1./30,1./60}) {
    test::SmallStepWorld rig({count, 0.01});
    btSoftBody& s=rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 0.5, n));
    { WetCloth w(rig.world(), s, fabrics::cottonPlain()); w.soak(0.35); rig.run(1,dt);} 
    double before=test::mass(s.m_nodes[n*n/2]);
    WetCloth dry(rig.world(), s, fabrics::cottonPlain()); double v=0; for (int i=0;i<60;++i) { rig.run(dt,dt); for (int k=0;k<s.m_nodes.size();++k) v=std::max(v,double(s.m_nodes[k].m_v.length())); }
    printf("n %d count %d dt 1/%.0f: v %.3f strain %.4f lowest %.4f mass %g->%g\n", n, count, 1/dt, v, test::largestStrain(s), double(s.m_nodes[n*n-1].m_x.y()), before, test::mass(s.m_nodes[n*n/2]));
  }
}
}}
