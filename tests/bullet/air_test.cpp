#include <gtest/gtest.h>

#include "worlds.h"

namespace drench {
namespace {

using test::FreeSheet;

/// Sum of the forces that the layer puts on the nodes for a substep.
btVector3 force(FreeSheet& rig, double dt) {
    rig.cloth().preSubstep(btScalar(dt));
    btVector3 total(0, 0, 0);
    for (int n = 0; n < rig.sheet().m_nodes.size(); ++n) {
        total += rig.sheet().m_nodes[n].m_f;
        rig.sheet().m_nodes[n].m_f.setZero();
    }
    return total;
}

Fabric airtight() {
    Fabric fabric = fabrics::cottonPlain();
    fabric.airPermeabilityDry = 0;
    fabric.airPermeabilitySaturated = 0;
    return fabric;
}

TEST(Air, DragOfAFlatSheetGrowsWithTheSquareOfSpeed) {
    FreeSheet rig(airtight());
    for (const double speed : {0.5, 2.0, 5.0, 30.0}) {
        rig.cloth().air().wind = {0, speed, 0};
        // 1/2 rho C_n A u^2; a very short step, so that the limiter has nothing to limit.
        EXPECT_NEAR(double(force(rig, 1e-7).y()), 0.5 * 1.2 * 1.2 * speed * speed,
                    0.002 * 0.72 * speed * speed);
        rig.cloth().air().wind = {speed, 0, 0};
        EXPECT_NEAR(double(force(rig, 1e-7).x()), 0.5 * 1.2 * 0.03 * speed * speed,
                    0.002 * 0.018 * speed * speed);
    }
}

TEST(Air, APermeableSheetLetsSomeThroughAndAWetOneLess) {
    Fabric gauze = fabrics::cottonPlain();
    gauze.airPermeabilityDry = 5;
    gauze.airPermeabilitySaturated = 0;
    FreeSheet rig(gauze);
    rig.cloth().air().wind = {0, 5, 0};
    const double dry = double(force(rig, 1e-7).y());
    // Solve v = u - (5 / 100) * 0.72 v^2 by hand: v = 4.3262 m/s, pressure 13.476 Pa.
    EXPECT_NEAR(dry, 13.476, 0.01);
    rig.cloth().soak(gauze.poreCapacity());
    for (int i = 0; i < 30; ++i) force(rig, 1);
    EXPECT_NEAR(double(force(rig, 1e-7).y()), 0.72 * 25, 0.05);
}

TEST(Air, DragStopsRelativeMotionButNeverTurnsIt) {
    for (const double speed : {1.0, 10.0, 60.0}) {
        FreeSheet rig(airtight());
        rig.cloth().air().wind = {0, speed, 0};
        double before = 0;
        for (int i = 0; i < 200; ++i) {
            rig.cloth().preSubstep(btScalar(1.0 / 30));
            double fastest = -1e9, slowest = 1e9;
            for (int n = 0; n < rig.sheet().m_nodes.size(); ++n) {
                btSoftBody::Node& node = rig.sheet().m_nodes[n];
                node.m_v += node.m_f * node.m_im / 30;
                node.m_f.setZero();
                fastest = std::max(fastest, double(node.m_v.y()));
                slowest = std::min(slowest, double(node.m_v.y()));
            }
            EXPECT_LE(fastest, speed * (1 + 1e-5)) << "after step " << i;
            EXPECT_GE(slowest, before - 1e-5 * speed) << "after step " << i;
            before = slowest;
        }
        EXPECT_GT(before, 0.8 * speed);
    }
}

}  // namespace
}  // namespace drench
