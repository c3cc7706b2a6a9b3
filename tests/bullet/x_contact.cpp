#include <gtest/gtest.h>
#include <string>
#include "worlds.h"
namespace drench { namespace {
std::unique_ptr<btSoftBody> level(btSoftBodyWorldInfo& info, const Fabric& f, double side, int nodes, double h) {
  return makeSheet(info, f, flatCorners({btScalar(-side/2), btScalar(h), btScalar(-side/2)}, {btScalar(side),0,0}, {0,0,btScalar(side)}), nodes, nodes);
}
void stats(const btSoftBody& s, const char* what) {
  double v=0, lo=1e9, ke=0; for (int n=0;n<s.m_nodes.size();++n){ v=std::max<double>(v,double(s.m_nodes[n].m_v.length())); lo=std::min<double>(lo,double(s.m_nodes[n].m_x.y())); ke+=0.5*test::mass(s.m_nodes[n])*double(s.m_nodes[n].m_v.length2()); }
  printf("%s: max v %.4f lowest %.4f ke %.3e strain %.4f\n", what, v, lo, ke, test::largestStrain(s));
}
TEST(X, BallImpact) {
  for (double speed : {0., 5., 15.}) for (int steps : {4, 20, 0}) for (int n : {33}) {
    test::SmallStepWorld rig({steps, 0.01});
    rig.bullet().addBall({0,0,0}, 0.25, 0);
    btSoftBody& s = rig.add(level(rig.info(), fabrics::cottonPlain(), 1, n, 0.3));
    rig.cover(s, fabrics::cottonPlain()); s.m_cfg.kDF=0.5;
    for (int i=0;i<s.m_nodes.size();++i) s.m_nodes[i].m_v.setValue(0,btScalar(-speed),0);
    double worst=0, worstAfter=0; for (int f=0; f<180; ++f) { rig.run(1./60); double pen=0; for (int i=0;i<s.m_nodes.size();++i) pen=std::max(pen, 0.25-double(s.m_nodes[i].m_x.length())); worst=std::max(worst,pen); if (f>120) worstAfter=std::max(worstAfter,pen);} 
    printf("speed %g steps %d (%d): worst pen %.5f at rest %.5f margin %.4f contacts %d  ", speed, steps, rig.solver().steps(), worst, worstAfter, double(s.getCollisionShape()->getMargin()), s.m_rcontacts.size()); stats(s, "");
  }
}
TEST(X, FastSmallBallAgainstRestingSheet) {
  for (double r : {0.03, 0.1}) for (double speed : {3., 5., 10., 20.}) {
    test::SmallStepWorld rig({20, 0.01});
    rig.setGravity({0,0,0});
    btSoftBody& s = rig.add(level(rig.info(), fabrics::cottonPlain(), 1, 33, 0));
    rig.cover(s, fabrics::cottonPlain());
    auto& ball = rig.bullet().addBall({btScalar(0.01),btScalar(0.5),btScalar(0.005)}, r, 0.05); ball.setLinearVelocity({0,btScalar(-speed),0});
    double worst=0; double p0=0.05*speed; for (int f=0; f<int(60*1.0/speed+5); ++f) { rig.run(1./60); double pen=0; for (int i=0;i<s.m_nodes.size();++i) pen=std::max(pen, r-double((s.m_nodes[i].m_x-ball.getWorldTransform().getOrigin()).length())); worst=std::max(worst,pen);} 
    double p=0.05*double(ball.getLinearVelocity().y()); for (int i=0;i<s.m_nodes.size();++i) p+=test::mass(s.m_nodes[i])*double(s.m_nodes[i].m_v.y());
    printf("r %g speed %g: ball y %.3f vy %.3f worst pen %.5f momentum %.6f of %.6f ", r, speed, double(ball.getWorldTransform().getOrigin().y()), double(ball.getLinearVelocity().y()), worst, p, -p0); stats(s,"");
  }
}
TEST(X, Incline) {
  for (double mu : {0.2, 0.4}) for (int steps : {4, 20, 0}) {
    test::SmallStepWorld rig({steps, 0.01});
    const double angle = 20*3.14159265358979/180;
    auto& box = rig.bullet().addBox({0,0,0}, {10, btScalar(0.5), 10});
    btTransform t; t.setIdentity(); t.setRotation(btQuaternion({0,0,1}, btScalar(angle))); box.setWorldTransform(t); box.setInterpolationWorldTransform(t);
    rig.world().updateAabbs();
    btSoftBody& s = rig.add(level(rig.info(), fabrics::cottonPlain(), 0.5, 17, 0));
    const double m = double(s.getCollisionShape()->getMargin());
    s.transform(btTransform(t.getRotation(), t*btVector3(6, btScalar(0.5+m), 0)));
    box.setFriction(1); rig.cover(s, fabrics::cottonPlain()); s.m_cfg.kDF = btScalar(mu); s.m_cfg.kDP=0;
    const btVector3 down = t.getBasis()*btVector3(-1,0,0);
    for (int f=0; f<120; ++f) rig.run(1./60);
    double v=0; for (int i=0;i<s.m_nodes.size();++i) v+=double(s.m_nodes[i].m_v.dot(down))/s.m_nodes.size();
    printf("mu %g steps %d: v %.4f of %.4f ", mu, steps, v, 9.81*(std::sin(angle)-mu*std::cos(angle))*2); stats(s,"");
  }
}
TEST(X, DynamicBallOnHangingNet) {
  for (double m : {0.05, 0.5, 5.}) for (int steps : {20, 0}) {
    test::SmallStepWorld rig({steps, 0.01});
    btSoftBody& s = rig.add(level(rig.info(), fabrics::cottonPlain(), 1, 25, 0));
    for (int i=0;i<25;++i) for (int k : {i, 600+i, 25*i, 25*i+24}) s.m_nodes[k].m_im = 0;
    rig.cover(s, fabrics::cottonPlain()); s.m_cfg.kDP=1; s.m_cfg.kDF=0.5;
    auto& ball = rig.bullet().addBall({0,btScalar(0.3),0}, 0.1, m);
    double worst=0; for (int f=0; f<600; ++f) { rig.run(1./60); double pen=0; for (int i=0;i<s.m_nodes.size();++i) pen=std::max(pen, 0.1-double((s.m_nodes[i].m_x-ball.getWorldTransform().getOrigin()).length())); worst=std::max(worst,pen);
      if (f%100==99 ) {printf("  m %g steps %d f %d ball y %.4f v %.5f w %.4f pen %.5f ", m, steps, f, double(ball.getWorldTransform().getOrigin().y()), double(ball.getLinearVelocity().length()), double(ball.getAngularVelocity().length()), worst); stats(s,"");} }
  }
}
TEST(X, AnchoredWeight) {
  for (double m : {0.005, 0.05, 0.5, 5.}) for (double infl : {1.0, 0.3}) {
    test::SmallStepWorld rig({20, 0.01});
    btSoftBody& s = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 0.5, 17));
    rig.cover(s, fabrics::cottonPlain()); s.m_cfg.kDP=1;
    auto& ball = rig.bullet().addBall({0,btScalar(-0.6),0}, 0.05, m);
    s.appendAnchor(16*17+8, &ball, true, btScalar(infl));
    for (int f=0; f<600; ++f) { rig.run(1./60); if (f%200==199) {printf("  m %g infl %g f %d ball y %.4f v %.5f ", m, infl, f, double(ball.getWorldTransform().getOrigin().y()), double(ball.getLinearVelocity().length())); stats(s,"");} }
  }
}
TEST(X, KinematicAnchor) {
    test::SmallStepWorld rig({20, 0.01}); rig.setGravity({0,0,0});
    btSoftBody& s = rig.add(level(rig.info(), fabrics::cottonPlain(), 0.5, 17, 0));
    rig.cover(s, fabrics::cottonPlain()); s.m_cfg.kDP=1;
    auto& ball = rig.bullet().addBall({0,0,btScalar(-0.4)}, 0.05, 0);
    ball.setCollisionFlags(ball.getCollisionFlags()|btCollisionObject::CF_KINEMATIC_OBJECT); ball.setActivationState(DISABLE_DEACTIVATION);
    for (int i=0;i<17;++i) s.appendAnchor(i, &ball, true, 1);
    for (int f=0; f<120; ++f) { btTransform t=ball.getWorldTransform(); t.setOrigin(t.getOrigin()+btVector3(0,0,btScalar(-1./60))); ball.setWorldTransform(t); rig.run(1./60); if (f%20==19) {printf("  f %d ball z %.4f node z %.4f v %.4f ", f, double(ball.getWorldTransform().getOrigin().z()), double(s.m_nodes[8].m_x.z()), double(s.m_nodes[8].m_v.z())); stats(s,"");} }
}
TEST(X, PinsMoved) {
  for (int mode : {0,1}) for (int steps : {4,20,100}) {
    test::SmallStepWorld rig({steps, 0.01});
    btSoftBody& s = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 0.5, 17));
    rig.cover(s, fabrics::cottonPlain()); s.m_cfg.kDP=1;
    double vmax=0, smax=0; for (int f=0; f<120; ++f) { for (int i=0;i<17;++i) { if (mode==0) s.m_nodes[i].m_x += btVector3(0,0,btScalar(1./60)); else s.m_nodes[i].m_v.setValue(0,0,1);} rig.run(1./60); for (int i=0;i<s.m_nodes.size();++i) vmax=std::max(vmax,double(s.m_nodes[i].m_v.length())); smax=std::max(smax,test::largestStrain(s)); }
    printf("%s steps %d: pin z %.4f largest v ever %.3f largest strain ever %.4f ", mode?"m_v":"m_x", steps, double(s.m_nodes[8].m_x.z()), vmax, smax); stats(s,"");
  }
}
TEST(X, FreeFall) {
  for (double v0 : {0., 10.}) for (int steps : {1,4,20,100,400}) {
    test::SmallStepWorld rig({steps, 0.01});
    Fabric f=fabrics::cottonPlain(); f.arealDensity=3; f.thickness=0.01;
    btSoftBody& s = rig.add(test::hangingSheet(rig.info(), f, 0.5, 17));
    for (int i=0;i<s.m_nodes.size();++i) s.m_nodes[i].m_im=1;
    auto& cloth=rig.cover(s, f); (void)cloth; s.m_cfg.kDP=0;
    for (int i=0;i<s.m_nodes.size();++i) s.m_nodes[i].m_v.setValue(0,btScalar(-v0),0);
    cloth.air().wind = {0,-v0,0}; // moves with it at first
    rig.run(1.0);
    btVector3 p(0,0,0); double m=0; for (int i=0;i<s.m_nodes.size();++i) { p+=s.m_nodes[i].m_v*btScalar(test::mass(s.m_nodes[i])); m+=test::mass(s.m_nodes[i]);} p/=btScalar(m);
    printf("v0 %g steps %d: v %.6f of %.6f (%.4f%% of gravity) x %.2e z %.2e ", v0, steps, double(p.y()), -v0-9.81, 100*(double(-p.y())-v0-9.81)/9.81, double(p.x()), double(p.z())); stats(s,"");
  }
}
TEST(X, Factors) {
    test::SmallStepWorld rig({20, 0.01});
    btSoftBody& s = rig.add(level(rig.info(), fabrics::cottonPlain(), 1, 25, 0.3));
    rig.cover(s, fabrics::cottonPlain());  s.m_cfg.kDF=1;
    auto& ball = rig.bullet().addBall({btScalar(0.3),0,0}, 0.1, 0.1); ball.setGravity({0,0,0}); ball.setLinearFactor({0,0,0}); ball.setAngularFactor(0);
    rig.run(1);
    printf("locked ball moved to %g %g %g, spin %g\n", double(ball.getWorldTransform().getOrigin().x()), double(ball.getWorldTransform().getOrigin().y()), double(ball.getWorldTransform().getOrigin().z()), double(ball.getAngularVelocity().length()));
}
}}
