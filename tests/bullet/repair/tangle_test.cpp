// A sheet that crosses itself for long is reported, whatever moves it.
#include <cmath>
#include <stdexcept>

#include "bullet/world/any_world.h"
#include "oracle/crossing_oracle.h"

namespace drench::tangle_test {
namespace {

using test::AnyWorld;
using test::Mover;

// Winds a sheet through itself, once, and holds it there.
void windUp(btSoftBody& body) {
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        btSoftBody::Node& node = body.m_nodes[n];
        const double angle = 2.2 * SIMD_PI * (double(node.m_x.x()) + 0.25) / 0.5;
        const double radius = 0.08 + 0.02 * std::cos(angle / 1.1);
        node.m_x.setX(btScalar(radius * std::cos(angle)));
        node.m_x.setZ(btScalar(radius * std::sin(angle)));
        node.m_q = node.m_x;
        node.m_im = 0;
    }
}

bool isReported(const WetCloth& cloth) {
    for (const TroubleReport& report : cloth.troubles())
        if (report.what == Trouble::crossing) return true;
    return false;
}

void runFor(AnyWorld& rig, double time) {
    rig.run(static_cast<int>(std::lround(time / rig.substep())));
}

TEST(Tangle, ThatLastsIsReportedUnderAllSolvers) {
    for (const Mover mover : test::movers) {
        SCOPED_TRACE(test::nameOf(mover));
        AnyWorld rig(mover, {}, 21);
        windUp(rig.sheet());
        runFor(rig, 0.9);
        EXPECT_FALSE(isReported(rig.cloth()));
        runFor(rig, 0.3);
        const TroubleReport report = test::reportOf(rig.cloth(), Trouble::crossing);
        EXPECT_EQ(report.value, test::crossingsByCgal({&rig.sheet()}));
        EXPECT_GT(report.value, 10);
        EXPECT_GE(report.node, 0);
        EXPECT_NE(report.message.find(mover == Mover::smallSteps ? "does not get them apart"
                                                                 : "without a SmallStepSolver"),
                  std::string::npos)
            << report.message;
    }
}

TEST(Tangle, IsNoneWhereTheApplicationAllowsIt) {
    SheetSettings settings;
    settings.meetsItself = false;
    for (const Mover mover : test::movers) {
        SCOPED_TRACE(test::nameOf(mover));
        AnyWorld rig(mover, settings, 21);
        windUp(rig.sheet());
        runFor(rig, 1.5);
        EXPECT_TRUE(rig.cloth().troubles().empty());
    }
}

TEST(Tangle, IsThrownIfTheApplicationWantsThat) {
    for (const Mover mover : test::movers) {
        SCOPED_TRACE(test::nameOf(mover));
        AnyWorld rig(mover, test::throwing(), 21);
        windUp(rig.sheet());
        runFor(rig, 0.9);
        EXPECT_THROW(runFor(rig, 0.3), std::runtime_error);
        rig.world().clearForces();
        EXPECT_THROW(rig.run(1), std::runtime_error) << "until the cause is gone";
    }
}

TEST(Tangle, IsNotAHangingSheet) {
    for (const Mover mover : test::movers) {
        SCOPED_TRACE(test::nameOf(mover));
        AnyWorld rig(mover, {}, 21);
        runFor(rig, 1.5);
        EXPECT_TRUE(rig.cloth().troubles().empty());
    }
}

}  // namespace
}  // namespace drench::tangle_test
