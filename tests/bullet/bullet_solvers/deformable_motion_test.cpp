// How sheets move and what they meet in the deformable world, explicit and implicit.
#include <gtest/gtest.h>

#include <algorithm>

#include "deformable_rig.h"

namespace drench::deformable_motion_test {
namespace {

using namespace test;

class InBothModes : public testing::TestWithParam<Mode> {};
INSTANTIATE_TEST_SUITE_P(Deformable, InBothModes, testing::Values(Mode::explicitSteps, Mode::implicitSteps));

double totalMass(const btSoftBody& sheet) {
    double total = 0;
    for (int n = 0; n < sheet.m_nodes.size(); ++n) total += test::mass(sheet.m_nodes[n]);
    return total;
}

btVector3 momentum(const btSoftBody& sheet) {
    btVector3 total(0, 0, 0);
    for (int n = 0; n < sheet.m_nodes.size(); ++n)
        total += sheet.m_nodes[n].m_v * btScalar(test::mass(sheet.m_nodes[n]));
    return total;
}

TEST_P(InBothModes, FallsFreely) {
    DeformableWorld bullet(GetParam());
    const Fabric fabric = constantStiffness(100);
    const auto sheet = test::hangingSheet(bullet.info(), fabric, side, nodesAlongEdge);
    for (int n = 0; n < nodesAlongEdge; ++n) sheet->m_nodes[n].m_im = 1;
    bullet.add(*sheet);
    {
        WetCloth cloth(bullet.world(), *sheet, fabric);
        cloth.air().vapourExchange = 0;
        cloth.soakPores(0.1);
        constexpr double time = 0.1;
        bullet.step(time, static_cast<int>(std::ceil(time / longestStep(cloth))));
        // Edge on, so that the air hardly brakes it.
        EXPECT_NEAR(double(momentum(*sheet).y()) / totalMass(*sheet), -9.81 * time, 0.01 * 9.81 * time);
        EXPECT_LT(test::largestStrain(*sheet), 1e-3);
    }
    bullet.world().removeSoftBody(sheet.get());
}

TEST_P(InBothModes, WaterBringsItsMomentum) {
    DeformableWorld bullet(GetParam(), 0);
    const Fabric fabric = constantStiffness(100);
    const auto sheet = test::hangingSheet(bullet.info(), fabric, side, nodesAlongEdge);
    for (int n = 0; n < nodesAlongEdge; ++n) sheet->m_nodes[n].m_im = 1;
    bullet.add(*sheet);
    {
        WetCloth cloth(bullet.world(), *sheet, fabric);
        cloth.air().vapourExchange = 0;
        constexpr double water = 1e-4, speed = 3;
        cloth.addWater(nodesAlongEdge * 8 + 8, water, {btScalar(speed), 0, 0});
        // Bullet's conjugate gradients stop early in single precision; the stiffer a step, the more is lost.
        bullet.step(std::min(longestStep(cloth), 1e-3), 1);
        EXPECT_NEAR(double(momentum(*sheet).x()), water * speed, 0.01 * water * speed);
    }
    bullet.world().removeSoftBody(sheet.get());
}

TEST_P(InBothModes, WindBlowsItAway) {
    DeformableWorld bullet(GetParam(), 0);
    const Fabric fabric = constantStiffness(100);
    const auto sheet = test::hangingSheet(bullet.info(), fabric, side, nodesAlongEdge);
    bullet.add(*sheet);
    {
        WetCloth cloth(bullet.world(), *sheet, fabric);
        cloth.air().wind = {0, 0, 2};
        for (int i = 0; i < 30; ++i)
            bullet.step(1.0 / 60, static_cast<int>(std::ceil(1.0 / 60 / longestStep(cloth))));
        EXPECT_GT(double(sheet->m_nodes[nodesAlongEdge * nodesAlongEdge - 1].m_x.z()), 0.1);
        EXPECT_LT(test::largestStrain(*sheet), 0.3);
        EXPECT_EQ(double(sheet->m_nodes[0].m_x.z()), 0);
    }
    bullet.world().removeSoftBody(sheet.get());
}

// From soaked to dry at the longest step: light as it gets, the sheet is still stable.
TEST_P(InBothModes, DriesWithoutBlowingUp) {
    DeformableWorld bullet(GetParam());
    Fabric fabric = fabrics::cottonPlain();
    fabric.stretchWarp = 100;
    fabric.stretchWeft = 100;
    fabric.shear = 20;
    const auto sheet = test::hangingSheet(bullet.info(), fabric, side, nodesAlongEdge);
    pinCorners(*sheet);
    bullet.add(*sheet);
    {
        SheetSettings settings;
        settings.waterSpeed = 1e4;
        WetCloth cloth(bullet.world(), *sheet, fabric, settings);
        cloth.air().humidity = 0.1;
        cloth.soakFilm(0.4);
        const double dt = longestStep(cloth);
        double wet = 0;
        for (double time = 0; time < 3; time += 1.0 / 60) {
            bullet.step(1.0 / 60, static_cast<int>(std::ceil(1.0 / 60 / dt)));
            wet = std::max(wet, totalMass(*sheet));
            ASSERT_LT(test::largestStrain(*sheet), 0.5) << time;
        }
        EXPECT_GT(wet, 2 * cloth.dryMass());
        EXPECT_LT(cloth.waterMass(), 0.05 * cloth.dryMass());
    }
    bullet.world().removeSoftBody(sheet.get());
}

TEST(DeformableWorld, CantileverSagsByItsBendingRigidity) {
    DeformableWorld bullet(Mode::implicitSteps);
    Fabric fabric = constantStiffness(2000);
    fabric.bending = 2e-3;
    constexpr int along = 18, across = 9;
    constexpr double cell = 0.00625;
    const auto sheet = makeSheet(
        bullet.info(), fabric,
        flatCorners({0, 0, 0}, {btScalar((along - 1) * cell), 0, 0}, {0, 0, btScalar((across - 1) * cell)}),
        along, across);
    for (int n = 0; n < sheet->m_nodes.size(); ++n)
        if (n % along < 2) sheet->m_nodes[n].m_im = 0;
    bullet.add(*sheet);
    {
        WetCloth cloth(bullet.world(), *sheet, fabric);
        cloth.air().vapourExchange = 0;
        for (int i = 0; i < 240; ++i) {
            bullet.step(1.0 / 240, 1);
            for (int n = 0; n < sheet->m_nodes.size(); ++n) sheet->m_nodes[n].m_v *= btScalar(0.9);
        }
        const double load = cloth.nodeMass(along * 4 + 8) / (cell * cell) * 9.81;
        // The second pinned column has the curvature of half a cell to either side.
        const double length = (along - 1.5) * cell;
        const double expected = load * std::pow(length, 4) / (8 * fabric.bending);
        const double found = -double(sheet->m_nodes[along * 5 - 1].m_x.y());
        RecordProperty("deflection_error", std::to_string(found / expected - 1));
        EXPECT_NEAR(found, expected, 0.04 * expected);
    }
    bullet.world().removeSoftBody(sheet.get());
}

TEST_P(InBothModes, AWetSheetRestsOnABall) {
    DeformableWorld bullet(GetParam());
    const Fabric fabric = constantStiffness(100);
    const btVector3 centre(0, 0, 0);
    constexpr double radius = 0.15;
    const btRigidBody& ball = bullet.addBall(centre, radius);
    const auto sheet =
        makeSheet(bullet.info(), fabric,
                  flatCorners({btScalar(-side / 2), btScalar(radius + 0.03), btScalar(-side / 2)},
                              {btScalar(side), 0, 0}, {0, 0, btScalar(side)}),
                  nodesAlongEdge, nodesAlongEdge);
    sheet->m_cfg.kDF = 1;
    const int collisions = sheet->m_cfg.collisions;
    bullet.add(*sheet);
    {
        WetCloth cloth(bullet.world(), *sheet, fabric);
        cloth.air().vapourExchange = 0;
        cloth.soakPores(fabric.arealDensity);
        WetBody& wet = cloth.add(WetBody(ball));
        wet.filmThickness = 1e-4;
        const int substeps = GetParam() == Mode::implicitSteps
                                 ? 4
                                 : std::max(16, static_cast<int>(std::ceil(1.0 / 60 / cloth.stepBound())));
        double closest = 1;
        for (int i = 0; i < 60; ++i) {
            bullet.step(1.0 / 60, substeps);
            ASSERT_TRUE(test::isFinite(*sheet)) << i;
            ASSERT_LT(largestExtension(*sheet), 0.15) << i;
            for (int n = 0; n < sheet->m_nodes.size(); ++n)
                closest = std::min(closest, double((sheet->m_nodes[n].m_x - centre).length()));
        }
        EXPECT_GT(closest, radius - 0.002);
        EXPECT_GT(double(sheet->m_nodes[nodesAlongEdge * nodesAlongEdge / 2].m_x.y()), radius);
        EXPECT_GT(cloth.ledger().supplied, 1.05 * fabric.arealDensity * side * side);  // from the ball
        EXPECT_GT(sheet->m_nodeRigidContacts.size(), 0);
        EXPECT_EQ(sheet->m_rcontacts.size(), 0);
        EXPECT_EQ(sheet->m_cfg.collisions & btSoftBody::fCollision::SDF_RD, btSoftBody::fCollision::SDF_RD);
    }
    EXPECT_EQ(sheet->m_cfg.collisions, collisions);
    bullet.world().removeSoftBody(sheet.get());
}

// With pins, and as stiff as cotton.
TEST(DeformableWorld, ImplicitCurtainIsBlownAgainstABall) {
    DeformableWorld bullet(Mode::implicitSteps);
    const btVector3 centre(0, btScalar(-0.3), btScalar(0.17));
    constexpr double radius = 0.15;
    bullet.addBall(centre, radius);
    const auto sheet = test::hangingSheet(bullet.info(), fabrics::cottonPlain(), side, nodesAlongEdge);
    bullet.add(*sheet);
    {
        WetCloth cloth(bullet.world(), *sheet, fabrics::cottonPlain());
        cloth.soakPores(0.1);
        cloth.air().wind = {0, 0, 4};
        int touched = 0;
        double closest = 1;
        for (int i = 0; i < 60; ++i) {
            bullet.step(1.0 / 60, 4);
            touched = std::max(touched, sheet->m_nodeRigidContacts.size());
            ASSERT_LT(largestExtension(*sheet), 0.1) << i;
            for (int n = 0; n < sheet->m_nodes.size(); ++n)
                closest = std::min(closest, double((sheet->m_nodes[n].m_x - centre).length()));
        }
        EXPECT_GT(touched, 10);
        EXPECT_GT(closest, radius - 0.005);
    }
    bullet.world().removeSoftBody(sheet.get());
}

TEST(DeformableWorld, SheetsThatTouchShareTheirWater) {
    DeformableWorld bullet(Mode::explicitSteps, 0);
    const Fabric fabric = constantStiffness(100);
    const auto level = [&](double height) {
        auto sheet =
            makeSheet(bullet.info(), fabric,
                      flatCorners({0, btScalar(height), 0}, {btScalar(side), 0, 0}, {0, 0, btScalar(side)}),
                      nodesAlongEdge, nodesAlongEdge);
        sheet->m_cfg.collisions |= btSoftBody::fCollision::VF_DD;
        bullet.add(*sheet);
        return sheet;
    };
    const auto lower = level(0), upper = level(0.01);
    {
        WetCloth wet(bullet.world(), *lower, fabric), dry(bullet.world(), *upper, fabric);
        wet.soakPores(0.1);
        const double before = dry.waterMass();
        dry.add(Touch(wet));
        for (int i = 0; i < 10; ++i) bullet.step(1.0 / 60, 27);
        EXPECT_GT(dry.waterMass(), before + 1e-5);
    }
    bullet.world().removeSoftBody(lower.get());
    bullet.world().removeSoftBody(upper.get());
}

}  // namespace
}  // namespace drench::deformable_motion_test
