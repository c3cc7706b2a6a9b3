#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "bullet/world/worlds.h"

namespace drench::air_test {
namespace {

using test::FreeSheet;

// Sum of the forces that the layer puts on the nodes for a substep.
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
    rig.cloth().soakFilm(gauze.poreCapacity());
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

TEST(Air, DragOfAFixedSheetKnowsNothingOfItsMass) {
    for (const double water : {0.0, 0.05, 0.2}) {
        FreeSheet rig(airtight());
        rig.cloth().air().vapourExchange = 0;
        rig.cloth().soakPores(water);
        for (int n = 0; n < rig.sheet().m_nodes.size(); ++n) rig.sheet().m_nodes[n].m_im = 0;
        for (const double speed : {0.5, 1.0, 3.0, 10.0, 30.0}) {
            rig.cloth().air().wind = {0, speed, 0};
            const double drag = 0.5 * 1.2 * 1.2 * speed * speed;
            EXPECT_NEAR(double(force(rig, 1e-7).y()), drag, 0.002 * drag) << water << " kg/m2 of water";
        }
    }
}

constexpr double degrees = 180 / 3.14159265358979;

// So stiff that it neither bends nor twists.
Fabric board() {
    Fabric fabric = airtight();
    fabric.bending = 0.1;
    return fabric;
}

// A panel, 0.4 m wide and 0.2 m high, of two rows of nodes: hinged along the upper one.
std::unique_ptr<btSoftBody> panel(btSoftBodyWorldInfo& info) {
    auto body =
        makeSheet(info, board(), flatCorners({0, 0, 0}, {btScalar(0.4), 0, 0}, {0, btScalar(-0.2), 0}), 3, 2);
    for (int n = 0; n < 3; ++n) body->m_nodes[n].m_im = 0;
    return body;
}

// Of the mean place of nodes under the axis x = y = 0, in the mean over two seconds, from the vertical.
double meanDeflection(test::SmallStepWorld& rig, const btSoftBody& body) {
    btVector3 sum(0, 0, 0);
    for (int i = 0; i < 120; ++i) {
        rig.run(1.0 / 60);
        for (int n = 0; n < body.m_nodes.size(); ++n) sum += body.m_nodes[n].m_x;
    }
    return degrees * std::atan2(double(sum.z()), -double(sum.y()));
}

// Where weight and wind turn it equally, rho_A g sin = 1/2 rho C_n U^2 cos^2; shear pulls through the hinge.
double deflectionOfAHingedPanel(double massPerArea, double speed) {
    double low = 0, high = 90 / degrees;
    for (int halving = 0; halving < 50; ++halving) {
        const double middle = 0.5 * (low + high);
        const double wind = 0.5 * 1.2 * 1.2 * speed * speed * std::cos(middle) * std::cos(middle);
        (massPerArea * 9.81 * std::sin(middle) > wind ? high : low) = middle;
    }
    return degrees * low;
}

TEST(Air, DeflectsAHingedPanelAsFarAsItShould) {
    for (const double water : {0.0, 0.2})
        for (const double speed : {1.0, 2.0, 5.0, 10.0}) {
            test::SmallStepWorld rig;
            btSoftBody& body = rig.add(panel(rig.info()));
            WetCloth& cloth = rig.cover(body, board());
            cloth.soakPores(water);
            cloth.air().vapourExchange = 0;
            cloth.air().wind = {0, 0, speed};
            rig.run(6);
            const double massPerArea = (cloth.dryMass() + cloth.waterMass()) / (0.4 * 0.2);
            // A little less wet: some of the water sinks to the lower edge.
            EXPECT_NEAR(meanDeflection(rig, body), deflectionOfAHingedPanel(massPerArea, speed), 0.5)
                << water << " kg/m2 of water, " << speed << " m/s";
        }
}

TEST(Air, AStrongerWindNeverDeflectsASheetLess) {
    for (const double water : {0.0, 0.2}) {
        double before = -1;
        for (const double speed : {0.0, 0.5, 1.0, 2.0, 3.0, 5.0, 8.0, 12.0, 20.0}) {
            test::SmallStepWorld rig;
            btSoftBody& sheet = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 0.5, 17));
            WetCloth& cloth = rig.cover(sheet, fabrics::cottonPlain());
            cloth.soakPores(water);
            cloth.air().vapourExchange = 0;
            cloth.air().wind = {0, 0, speed};
            rig.run(3);
            const double deflection = meanDeflection(rig, sheet);
            EXPECT_GT(deflection, before) << water << " kg/m2 of water, " << speed << " m/s";
            before = deflection;
        }
        EXPECT_GT(before, 80);
    }
}

}  // namespace
}  // namespace drench::air_test
