// How sheets move with a SmallStepSolver: momentum, energy, pendulums, damping, forces and sleep, against closed
// forms.
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "bullet/world/worlds.h"

namespace drench::small_step_motion_test {
namespace {

constexpr double g = 9.81;

TEST(SmallStepMotion, FreeFallIsThatOfTheClosedForm) {
    for (const int steps : {1, 4, 20, 60}) {
        test::SmallStepWorld rig({steps, 0.01});
        btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.5, 17, 0));
        rig.cover(sheet, fabrics::cottonPlain(), test::withoutAir());
        test::setVelocity(sheet, {btScalar(0.3), -5, 0});
        rig.run(1);
        const btVector3 velocity = test::momentum(sheet) / btScalar(test::mass(sheet));
        // Symplectic: each step of h moves by the velocity at its end.
        const double h = 1.0 / 60 / steps, height = -5 - 0.5 * g * (1 + h);
        EXPECT_NEAR(double(velocity.x()), 0.3, 1e-5) << steps;
        EXPECT_NEAR(double(velocity.y()), -5 - g, 2e-4 * g) << steps;
        EXPECT_NEAR(double(velocity.z()), 0, 1e-6) << steps;
        EXPECT_NEAR(double(sheet.m_nodes[144].m_x.y()), height, 1e-3) << steps;
        EXPECT_LT(test::largestStrain(sheet), 1e-4) << steps;
    }
}

// About the centre of mass, kg m2/s.
btVector3 angularMomentum(const btSoftBody& sheet) {
    btVector3 centre(0, 0, 0), sum(0, 0, 0);
    for (int n = 0; n < sheet.m_nodes.size(); ++n)
        centre += sheet.m_nodes[n].m_x * btScalar(test::mass(sheet.m_nodes[n]) / test::mass(sheet));
    for (int n = 0; n < sheet.m_nodes.size(); ++n)
        sum += (sheet.m_nodes[n].m_x - centre).cross(sheet.m_nodes[n].m_v) *
               btScalar(test::mass(sheet.m_nodes[n]));
    return sum;
}

double kineticEnergy(const btSoftBody& sheet) {
    double sum = 0;
    for (int n = 0; n < sheet.m_nodes.size(); ++n)
        sum += test::mass(sheet.m_nodes[n]) * double(sheet.m_nodes[n].m_v.length2()) / 2;
    return sum;
}

TEST(SmallStepMotion, ASheetThatShakesKeepsItsMomentumAndAngularMomentum) {
    test::SmallStepWorld rig({20, 0.01});
    rig.setGravity({0, 0, 0});
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.5, 17, 0));
    rig.cover(sheet, fabrics::cottonPlain(), test::withoutAir());
    for (int n = 0; n < sheet.m_nodes.size(); ++n) {
        const btVector3& x = sheet.m_nodes[n].m_x;
        sheet.m_nodes[n].m_v =
            btVector3(1, btScalar(std::sin(20 * double(x.x()))), 0) + btVector3(0, 0, 2).cross(x);
    }
    const btVector3 before = test::momentum(sheet), spinBefore = angularMomentum(sheet);
    rig.run(1);
    EXPECT_LT(double((test::momentum(sheet) - before).length()), 1e-4 * double(before.length()));
    EXPECT_LT(double((angularMomentum(sheet) - spinBefore).length()), 1e-3 * double(spinBefore.length()));
}

// Without damping it keeps its angular momentum, and its energy sinks towards the least with which it can have that.
TEST(SmallStepMotion, ASheetThatTumblesKeepsItsAngularMomentum) {
    for (const double speed : {2.0, 10.0})
        for (const int nodes : {9, 17}) {
            test::SmallStepWorld rig;
            rig.setGravity({0, 0, 0});
            btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.5, nodes, 0));
            rig.cover(sheet, fabrics::cottonPlain(), test::withoutAir());
            const btVector3 spin(btScalar(speed), btScalar(0.2 * speed), btScalar(0.3 * speed));
            for (int n = 0; n < sheet.m_nodes.size(); ++n)
                sheet.m_nodes[n].m_v = spin.cross(sheet.m_nodes[n].m_x);
            const btVector3 before = angularMomentum(sheet);
            const double energyBefore = kineticEnergy(sheet);
            rig.run(10);
            EXPECT_LT(double((angularMomentum(sheet) - before).length()), 0.01 * double(before.length()));
            EXPECT_LT(kineticEnergy(sheet), energyBefore);
            EXPECT_GT(kineticEnergy(sheet), 0.4 * energyBefore);
        }
}

TEST(SmallStepMotion, ASheetThatTurnsIsDampedByItsDampingOnly) {
    test::SmallStepWorld rig;
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.5, 9, 0));
    rig.cover(sheet, fabrics::cottonPlain(), test::withoutAir());
    sheet.m_cfg.kDP = 0.5;
    for (int n = 0; n < sheet.m_nodes.size(); ++n)
        sheet.m_nodes[n].m_v = btVector3(0, 5, 0).cross(sheet.m_nodes[n].m_x);
    const btVector3 before = angularMomentum(sheet);
    rig.run(2);  // falling, which turns nothing
    EXPECT_LT(double((angularMomentum(sheet) - before * btScalar(std::exp(-1.0))).length()),
              0.01 * double(before.length()));
}

TEST(SmallStepMotion, DampingIsAShareOfTheVelocityPerSecond) {
    for (const double rate : {1.0, 5.0})
        for (const double frames : {30, 60, 240})
            for (const int steps : {1, 20, 60}) {
                test::SmallStepWorld rig({steps, 0.01});
                rig.setGravity({0, 0, 0});
                btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.1, 5, 0));
                rig.cover(sheet, fabrics::cottonPlain(), test::withoutAir());
                sheet.m_cfg.kDP = btScalar(rate);
                test::setVelocity(sheet, {1, 2, 0});
                rig.run(1, 1 / frames);
                const btVector3 velocity = test::momentum(sheet) / btScalar(test::mass(sheet));
                EXPECT_NEAR(double(velocity.x()) / std::exp(-rate), 1, 2e-3);
                EXPECT_NEAR(double(velocity.y()) / 2 / std::exp(-rate), 1, 2e-3);
            }
}

// First swing of a hanging chain: omega = j0 / 2 sqrt(g / L), j0 the first zero of the Bessel function.
TEST(SmallStepMotion, ANarrowStripSwingsAsAHangingChain) {
    constexpr double firstZero = 2.404825557695773, length = 0.5;
    constexpr int along = 17;
    Fabric fabric = fabrics::cottonPlain();
    fabric.bending = 1e-9;
    fabric.bendingFriction = 0;
    test::SmallStepWorld rig({60, 0.01});
    constexpr double cell = length / (along - 1);
    btSoftBody& strip = rig.add(
        makeSheet(rig.info(), fabric,
                  flatCorners({0, 0, 0}, {btScalar(2 * cell), 0, 0}, {0, btScalar(-length), 0}), 3, along));
    for (int i = 0; i < 3; ++i) strip.m_nodes[i].m_im = 0;
    rig.cover(strip, fabric, test::withoutAir());
    for (int n = 0; n < strip.m_nodes.size(); ++n) {
        btVector3& x = strip.m_nodes[n].m_x;
        x.setZ(
            btScalar(0.01 * std::cyl_bessel_j(0, firstZero * std::sqrt((length + double(x.y())) / length))));
    }
    const btVector3& tip = strip.m_nodes[1 + 3 * (along - 1)].m_x;
    std::vector<double> crossings;  // downwards through the middle
    double before = double(tip.z());
    constexpr double frame = 1.0 / 60;
    for (int i = 0; i < 360; ++i) {
        rig.run(frame);
        const double now = double(tip.z());
        if (before > 0 && now <= 0) crossings.push_back((i + before / (before - now)) * frame);
        before = now;
    }
    ASSERT_GE(crossings.size(), 3u);
    const double period = (crossings.back() - crossings.front()) / double(crossings.size() - 1),
                 expected = 2 * 3.14159265358979 / (firstZero / 2 * std::sqrt(g / length));
    RecordProperty("period_error", std::to_string(period / expected - 1));
    EXPECT_NEAR(period / expected, 1, 0.01);
}

// Kinetic energy, height and the springs of the fabric, put together from its formulas alone; J.
double energyOf(const btSoftBody& sheet, const Fabric& fabric, double side, int nodes) {
    double sum = 0;
    for (int n = 0; n < sheet.m_nodes.size(); ++n) {
        const btSoftBody::Node& node = sheet.m_nodes[n];
        sum += test::mass(node) * (0.5 * double(node.m_v.length2()) + g * double(node.m_x.y()));
    }
    const double cell = side / (nodes - 1);
    const auto add = [&](int a, int b, double length, double stiffness) {
        const double stretch = double((sheet.m_nodes[a].m_x - sheet.m_nodes[b].m_x).length()) - length;
        sum += 0.5 * stiffness * stretch * stretch;
    };
    for (int j = 0; j < nodes; ++j)
        for (int i = 0; i < nodes; ++i) {
            const int here = i + nodes * j, next = here + 1, below = here + nodes;
            const double rowFraction = j == 0 || j == nodes - 1 ? 0.5 : 1,
                         columnFraction = i == 0 || i == nodes - 1 ? 0.5 : 1;
            if (i + 1 < nodes) add(here, next, cell, (fabric.stretchWarp - fabric.shear) * rowFraction);
            if (j + 1 < nodes) add(here, below, cell, (fabric.stretchWeft - fabric.shear) * columnFraction);
            if (i + 1 == nodes || j + 1 == nodes) continue;
            add(here, below + 1, cell * std::sqrt(2.0), fabric.shear);
            add(next, below, cell * std::sqrt(2.0), fabric.shear);
        }
    return sum;
}

TEST(SmallStepMotion, EnergyNeverGrows) {
    constexpr int nodes = 17;
    constexpr double side = 0.5;
    Fabric fabric = fabrics::cottonPlain();
    fabric.stretchWarp = fabric.stretchWeft = 100;
    fabric.shear = 20;
    fabric.bending = 1e-9;  // not in the sum
    fabric.bendingFriction = 0;
    test::SmallStepWorld rig({20, 0.01});
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, side, nodes, 0));
    sheet.m_nodes[0].m_im = sheet.m_nodes[nodes - 1].m_im = 0;  // swings down from its upper corners
    rig.cover(sheet, fabric, test::withoutAir());
    const double span = test::mass(sheet) * g * side / 2, start = energyOf(sheet, fabric, side, nodes);
    double before = start, rise = 0;
    for (int i = 0; i < 600; ++i) {
        rig.run(1.0 / 60);
        const double now = energyOf(sheet, fabric, side, nodes);
        rise = std::max(rise, now - before);
        before = now;
    }
    EXPECT_LT(rise, 1e-3 * span);
    EXPECT_LT(before, start);
}

TEST(SmallStepMotion, StepsTooLongForTheClothAddNoSpeed) {
    // Such a sheet is too soft, but what it has of height and speed together it does not gain.
    for (const int nodes : {17, 33})
        for (const int steps : {1, 4, 0}) {
            test::SmallStepWorld rig({steps, 0.01});
            btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.5, nodes, 0));
            sheet.m_nodes[0].m_im = sheet.m_nodes[nodes - 1].m_im = 0;
            rig.cover(sheet, fabrics::cottonPlain(), test::withoutAir());
            double max = -1e9;
            for (int i = 0; i < 300; ++i) {
                rig.run(1.0 / 60);
                double sum = 0;
                for (int n = 0; n < sheet.m_nodes.size(); ++n)
                    sum += test::mass(sheet.m_nodes[n]) * (0.5 * double(sheet.m_nodes[n].m_v.length2()) +
                                                           g * double(sheet.m_nodes[n].m_x.y()));
                max = std::max(max, sum);
            }
            EXPECT_LT(max, 0.01 * test::mass(sheet) * g * 0.25);
        }
}

std::vector<btVector3> tumbled() {
    test::SmallStepWorld rig;
    rig.bullet().addGround(0);
    btRigidBody& ball = rig.bullet().addBall({btScalar(0.02), btScalar(0.3), 0}, 0.1, 0.2);
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.6, 21, 0.6));
    WetCloth& cloth = rig.cover(sheet, fabrics::cottonPlain());
    cloth.air().wind = {1, 0, 0.3};
    cloth.soakFilm(0.2);
    rig.run(1.5);
    std::vector<btVector3> result;
    for (int n = 0; n < sheet.m_nodes.size(); ++n) {
        result.push_back(sheet.m_nodes[n].m_x);
        result.push_back(sheet.m_nodes[n].m_v);
    }
    result.push_back(ball.getWorldTransform().getOrigin());
    result.push_back(ball.getAngularVelocity());
    return result;
}

TEST(SmallStepMotion, TheSameRunComesOutBitForBit) {
    const auto first = tumbled(), second = tumbled();
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            ASSERT_EQ(std::memcmp(&first[i].m_floats[axis], &second[i].m_floats[axis], sizeof(btScalar)), 0)
                << i;
}

TEST(SmallStepMotion, ForcesOfTheApplicationActOnNodes) {
    for (const int steps : {1, 20}) {
        test::SmallStepWorld rig({steps, 0.01});
        rig.setGravity({0, 0, 0});
        btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.5, 9, 0));
        rig.cover(sheet, fabrics::cottonPlain(), test::withoutAir());
        const double mass = test::mass(sheet);
        // Stock Bullet forgets forces after each substep, too.
        for (int i = 0; i < 60; ++i) {
            sheet.addForce({0, 0, btScalar(0.05)});  // on each node
            rig.run(1.0 / 60);
        }
        const double momentum = 0.05 * sheet.m_nodes.size();
        EXPECT_NEAR(double(test::momentum(sheet).z()) / momentum, 1, 1e-3);
        rig.run(0.5);
        EXPECT_NEAR(double(test::momentum(sheet).z()) / momentum, 1, 1e-3);
        EXPECT_GT(mass, 0);
    }
}

TEST(SmallStepMotion, GravityIsThatOfTheWorldInfo) {
    test::SmallStepWorld rig({20, 0.01});
    rig.world().setGravity({0, 0, 0});
    rig.info().m_gravity.setValue(3, 0, 0);
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.5, 9, 0));
    rig.cover(sheet, fabrics::cottonPlain(), test::withoutAir());
    rig.run(1);
    EXPECT_NEAR(double(test::momentum(sheet).x()) / test::mass(sheet), 3, 1e-3);
    EXPECT_NEAR(double(test::momentum(sheet).y()), 0, 1e-6);
}

TEST(SmallStepMotion, ASleepingSheetStaysAndWaterWakesIt) {
    test::SmallStepWorld rig({20, 0.01});
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.5, 9, 1));
    WetCloth& cloth = rig.cover(sheet, fabrics::cottonPlain());
    rig.run(0.1);
    sheet.setActivationState(ISLAND_SLEEPING);
    const btVector3 before = sheet.m_nodes[40].m_x;
    rig.run(0.5);
    EXPECT_EQ(before, sheet.m_nodes[40].m_x);
    cloth.addWater(40, 1e-3);
    rig.run(0.5);
    EXPECT_TRUE(sheet.isActive());
    EXPECT_LT(double(sheet.m_nodes[40].m_x.y()), double(before.y()) - 0.3);
}

}  // namespace
}  // namespace drench::small_step_motion_test
