#include <gtest/gtest.h>
#include "worlds.h"
namespace drench { namespace {
TEST(X, Net) {
  const double m = atof(getenv("M")); const int steps=atoi(getenv("ST")); const double df=atof(getenv("DF"));
    test::SmallStepWorld rig({steps, 0.01});
    btSoftBody& s = rig.add(makeSheet(rig.info(), fabrics::cottonPlain(), flatCorners({btScalar(-.5), 0, btScalar(-.5)}, {1,0,0}, {0,0,1}), 25, 25));
    for (int i=0;i<25;++i) for (int k : {i, 600+i, 25*i, 25*i+24}) s.m_nodes[k].m_im = 0;
    SheetSettings no; if (getenv("NOAIR")) no.stepping=Stepping::byApplication;
    rig.cover(s, fabrics::cottonPlain(), no); s.m_cfg.kDP=btScalar(getenv("DP")?atof(getenv("DP")):1); s.m_cfg.kDF=btScalar(df);
    auto& ball = rig.bullet().addBall({0,btScalar(getenv("H")?atof(getenv("H")):0.3),0}, 0.1, m); ball.setFriction(1); if (getenv("NOSLEEP")) ball.setActivationState(DISABLE_DEACTIVATION);
    for (int f=0; f<900; ++f) { rig.run(1./60); if (f%75==74) { auto x=ball.getWorldTransform().getOrigin(), v=ball.getLinearVelocity(), w=ball.getAngularVelocity(); double ke=0; for (int i=0;i<s.m_nodes.size();++i) ke+=.5*test::mass(s.m_nodes[i])*double(s.m_nodes[i].m_v.length2());
     printf("t %.2f x %.4f %.4f %.4f v %.4f %.4f %.4f w %.4f %.4f %.4f sheet ke %.2e contacts %d\n", (f+1)/60., double(x.x()),double(x.y()),double(x.z()),double(v.x()),double(v.y()),double(v.z()),double(w.x()),double(w.y()),double(w.z()), ke, s.m_rcontacts.size()); } }
}
}}
