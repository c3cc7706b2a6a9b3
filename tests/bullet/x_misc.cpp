#include <gtest/gtest.h>
#include "worlds.h"
namespace drench { namespace {
// resolution
double lowest(const btSoftBody& s) { double lo=0; for (int i=0;i<s.m_nodes.size();++i) lo=std::min(lo,double(s.m_nodes[i].m_x.y())); return lo; }
TEST(X, Resolution) {
  for (int corners : {0,1}) for (int n : {16,32,64,128}) for (double tol : {0.01, 0.001}) {
    if (n==128 && tol<0.01) continue;
    test::SmallStepWorld rig({0, tol});
    btSoftBody& s=rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 1, n));
    if (corners) for (int i=1;i<n-1;++i) s.m_nodes[i].m_im=1;
    rig.cover(s, fabrics::cottonPlain()); s.m_cfg.kDP=5;
    rig.run(n==128?1.5:4);
    printf("corners %d n %d tol %g steps %d: lowest %.5f\n", corners, n, tol, rig.solver().steps(), lowest(s));
  }
}
TEST(X, Dt) {
  for (int corners : {0,1}) for (double tol : {0.01,0.003}) for (double dt : {1./30,1./60,1./120,1./240}) {
    test::SmallStepWorld rig({0, tol});
    const int n=32;
    btSoftBody& s=rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 1, n));
    if (corners) for (int i=1;i<n-1;++i) s.m_nodes[i].m_im=1;
    rig.cover(s, fabrics::cottonPlain()); s.m_cfg.kDP=5;
    rig.run(4, dt);
    printf("corners %d tol %g dt 1/%.0f steps %d: lowest %.5f\n", corners, tol, 1/dt, rig.solver().steps(), lowest(s));
  }
}
}}
