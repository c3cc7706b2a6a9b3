// Sheets that touch each other or other soft bodies, tethers, and what a SmallStepSolver refuses and reports.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bullet/world/worlds.h"

namespace drench::small_step_touch_test {
namespace {

btVector3 momentum(const btSoftBody& body) {
    btVector3 sum(0, 0, 0);
    for (int n = 0; n < body.m_nodes.size(); ++n)
        if (body.m_nodes[n].m_im > 0) sum += body.m_nodes[n].m_v / body.m_nodes[n].m_im;
    return sum;
}

// A level sheet that touches other soft bodies.
std::unique_ptr<btSoftBody> touchingSheet(btSoftBodyWorldInfo& info, double side, int nodes, double height) {
    auto sheet = test::levelSheet(info, fabrics::cottonPlain(), side, nodes, height);
    sheet->m_cfg.collisions |= btSoftBody::fCollision::VF_SS;
    return sheet;
}

TEST(SmallStepTouch, TwoSheetsThatMeetKeepTheirMomentumAndDoNotPass) {
    test::SmallStepWorld rig;
    rig.setGravity({0, 0, 0});
    btSoftBody& lower = rig.add(touchingSheet(rig.info(), 0.5, 21, 0));
    btSoftBody& upper = rig.add(touchingSheet(rig.info(), 0.3, 12, 0.05));
    for (btSoftBody* body : {&lower, &upper})
        rig.cover(*body, fabrics::cottonPlain(), test::withoutAir()).air().vapourExchange = 0;
    test::setVelocity(upper, {0, -1, 0});
    const btVector3 before = momentum(lower) + momentum(upper);
    double largestFraction = 0;
    for (int i = 0; i < 20; ++i) {
        rig.run(1.0 / 60);
        largestFraction = std::max(largestFraction, double(momentum(lower).y() / before.y()));
    }
    const btVector3 after = momentum(lower) + momentum(upper);
    EXPECT_GT(largestFraction, 0.3) << "the lower sheet has not been hit";
    // The air takes some of it.
    EXPECT_NEAR(double((after - before).length() / before.length()), 0, 0.12);
    EXPECT_LT(std::abs(double(after.x() + after.z())), 1e-3 * double(before.length()));
    EXPECT_GT(test::lowest(upper), test::lowest(lower) - 0.01);
}

TEST(SmallStepTouch, ASheetRestsOnAPatchThatBulletMovesAndWeighsOnIt) {
    const auto sagOfPatch = [](bool loaded) {
        test::SmallStepWorld rig;
        std::unique_ptr<btSoftBody> made(btSoftBodyHelpers::CreatePatch(
            rig.info(), {btScalar(-0.3), 0, btScalar(-0.3)}, {btScalar(0.3), 0, btScalar(-0.3)},
            {btScalar(-0.3), 0, btScalar(0.3)}, {btScalar(0.3), 0, btScalar(0.3)}, 13, 13, 1 + 2 + 4 + 8,
            true));
        made->m_cfg.collisions |= btSoftBody::fCollision::VF_SS;
        made->m_cfg.piterations = 4;
        made->getCollisionShape()->setMargin(btScalar(0.01));
        made->setTotalMass(btScalar(0.05));
        btSoftBody& patch = rig.add(std::move(made));
        btSoftBody* sheet = nullptr;
        if (loaded) {
            sheet = &rig.add(touchingSheet(rig.info(), 0.3, 12, 0.03));
            rig.cover(*sheet, fabrics::denim()).soakFilm(0.3);
        }
        patch.m_cfg.kDP = btScalar(0.05);
        rig.run(3);
        if (sheet) {
            EXPECT_GT(test::lowest(*sheet), test::lowest(patch) - 0.01) << "it has fallen through";
        }
        return -test::lowest(patch);
    };
    EXPECT_GT(sagOfPatch(true), sagOfPatch(false) + 0.002);
}

TEST(SmallStepTouch, ASheetAndAPatchThatBulletMovesKeepTheirMomentum) {
    for (const double water : {0.0, 0.13}) {
        test::SmallStepWorld rig;
        rig.setGravity({0, 0, 0});
        std::unique_ptr<btSoftBody> made = test::patch(rig.info());
        made->translate({0, -1, 0});
        made->m_cfg.collisions |= btSoftBody::fCollision::VF_SS;
        made->setTotalMass(btScalar(0.05));
        for (int n = 0; n < made->m_nodes.size(); ++n)
            if (!(made->m_nodes[n].m_im > 0)) made->m_nodes[n].m_im = 1 / btScalar(0.05 / 289);
        btSoftBody& patch = rig.add(std::move(made));
        btSoftBody& sheet = rig.add(touchingSheet(rig.info(), 0.3, 12, 0.03));
        WetCloth& cloth = rig.cover(sheet, fabrics::cottonPlain(), test::withoutAir());
        cloth.soakPores(water);
        cloth.preSubstep(btScalar(1e-6));
        test::setVelocity(sheet, {0, btScalar(-0.5), 0});
        const btVector3 before = momentum(sheet) + momentum(patch);
        rig.run(0.5);
        EXPECT_GT(double(momentum(patch).length()), 0.1 * double(before.length())) << "they have not met";
        const btVector3 change = momentum(sheet) + momentum(patch) - before;
        EXPECT_LT(double(change.length()), 0.01 * double(before.length())) << water << " kg/m2";
    }
}

// Mean strain of a hanging square metre of cotton at rest in so many steps.
double strainAtRest(int nodes, int steps, bool tethers, double stretch) {
    Fabric fabric = fabrics::cottonPlain();
    fabric.stretchWarp = fabric.stretchWeft = stretch;
    fabric.shear = std::min(60.0, 0.1 * stretch);
    SmallStepSettings settings;
    settings.count = steps;
    settings.tethers = tethers;
    test::SmallStepWorld rig(settings);
    btSoftBody& sheet = rig.add(test::hangingSheet(rig.info(), fabric, 1, nodes));
    rig.cover(sheet, fabric);
    sheet.m_cfg.kDP = 4;
    rig.run(3);
    return test::meanStrain(sheet);
}

TEST(SmallStepTouch, TethersHoldAFineSheetTogetherInFewSteps) {
    const double without = strainAtRest(64, 6, false, 2000), with = strainAtRest(64, 6, true, 2000);
    EXPECT_GT(without, 0.03);
    EXPECT_LT(with, 0.4 * without);
}

TEST(SmallStepTouch, TethersDoNotHideTheStretchOfSoftCloth) {
    // Soft enough that it stretches by itself, by 2 % at the top; steps enough to resolve that.
    const double without = strainAtRest(33, 40, false, 65), with = strainAtRest(33, 40, true, 65);
    EXPECT_GT(without, 0.005);
    EXPECT_NEAR(with / without, 1, 0.02);
}

TEST(SmallStepTouch, HealthTellsHowTheSheetDoes) {
    test::SmallStepWorld rig({20, 0.01});
    rig.bullet().addBall({0, btScalar(-0.4), 0}, 0.25, 0);
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.8, 25, 0));
    const WetCloth& cloth = rig.cover(sheet, fabrics::cottonPlain());
    rig.run(1.5);
    const SheetHealth health = cloth.health();
    EXPECT_TRUE(health.finite);
    EXPECT_EQ(health.smallSteps, 20);
    EXPECT_EQ(health.heldSubsteps, 0);
    double largest = 0;
    for (int i = 0; i < sheet.m_links.size(); ++i) {
        const btSoftBody::Link& link = sheet.m_links[i];
        const double strain = double((link.m_n[1]->m_x - link.m_n[0]->m_x).length() / link.m_rl) - 1;
        if (!link.m_bbending) largest = std::max(largest, std::abs(strain));
    }
    EXPECT_NEAR(health.largestStrain, largest, 1e-6);
    EXPECT_GT(largest, 1e-4);
    EXPECT_EQ(health.deepestPenetration, 0);
    EXPECT_EQ(health.stepBound, cloth.stepBound());

    // A node that someone puts into the ball.
    for (int i = 0; i < sheet.m_rcontacts.size(); ++i) {
        btSoftBody::RContact& contact = sheet.m_rcontacts[i];
        contact.m_node->m_x -=
            contact.m_cti.m_normal * (sheet.getCollisionShape()->getMargin() + btScalar(0.003));
        break;
    }
    EXPECT_NEAR(cloth.health().deepestPenetration, 0.003, 5e-4);
    sheet.m_nodes[3].m_v.setX(std::numeric_limits<btScalar>::quiet_NaN());
    EXPECT_FALSE(cloth.health().finite);
}

// Reached by a body that nobody mends before the step.
TEST(SmallStepTouch, AbsurdSpeedsHoldTheSheet) {
    test::SmallStepWorld rig;
    btSoftBody& sheet = rig.add(test::smallSheet(rig.info()));
    SheetSettings settings;
    settings.stepping = Stepping::byApplication;
    WetCloth& cloth = rig.cover(sheet, fabrics::cottonPlain(), settings);
    rig.run(0.1);
    const btVector3 position = sheet.m_nodes[100].m_x;
    sheet.m_nodes[100].m_v.setY(btScalar(1e30));
    rig.run(1.0 / 60);
    EXPECT_EQ(cloth.health().heldSubsteps, 1);
    EXPECT_TRUE(cloth.health().finite);
    EXPECT_EQ(double((sheet.m_nodes[100].m_x - position).length()), 0);
    rig.run(0.5);
    EXPECT_EQ(cloth.health().heldSubsteps, 1);
    EXPECT_LT(test::largestStrain(sheet), 0.2);
}

TEST(SmallStepTouch, ASheetThatIsHeldBackHarmsNothingElse) {
    test::SmallStepWorld rig;
    btRigidBody& ball = rig.bullet().addBall({0, btScalar(-0.11), 0}, 0.1, 1);
    btSoftBody& sheet = rig.add(touchingSheet(rig.info(), 0.5, 17, 0));
    btSoftBody& neighbour = rig.add(touchingSheet(rig.info(), 0.3, 12, 0.02));
    SheetSettings settings;
    settings.stepping = Stepping::byApplication;  // so that nobody mends it before the step
    WetCloth& cloth = rig.cover(sheet, fabrics::cottonPlain(), settings);
    const WetCloth& other = rig.cover(neighbour, fabrics::cottonPlain());
    rig.run(0.1);
    sheet.m_nodes[100].m_v.setY(btScalar(1e30));
    rig.run(0.5);
    EXPECT_EQ(cloth.health().heldSubsteps, 1);
    EXPECT_TRUE(cloth.health().finite);
    EXPECT_TRUE(other.health().finite);
    EXPECT_TRUE(std::isfinite(ball.getWorldTransform().getOrigin().y() + ball.getLinearVelocity().y()));
    EXPECT_LT(double(ball.getLinearVelocity().length()), 10);
    for (int n = 0; n < sheet.m_nodes.size(); ++n) ASSERT_TRUE(std::isfinite(sheet.m_nodes[n].m_n.y())) << n;
}

TEST(SmallStepTouch, SheetsInOnePlaneFallAsOne) {
    test::SmallStepWorld rig;
    btSoftBody& first = rig.add(touchingSheet(rig.info(), 0.5, 11, 1));
    btSoftBody& second = rig.add(touchingSheet(rig.info(), 0.3, 8, 1));
    const WetCloth& cloth = rig.cover(first, fabrics::cottonPlain());
    rig.cover(second, fabrics::cottonPlain());
    rig.run(0.5);
    EXPECT_EQ(cloth.health().heldSubsteps, 0);
    EXPECT_LT(test::lowest(first), 0.6);
    EXPECT_LT(test::lowest(second), 0.6);
}

TEST(SmallStepTouch, ASheetWithATimeOfItsOwnDoesNotDisturbOthers) {
    const auto lifted = [](bool withSlowSheet) {
        test::SmallStepWorld rig;
        btBoxShape shape({btScalar(0.4), btScalar(0.02), btScalar(0.4)});
        btRigidBody plate(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &shape));
        plate.setCollisionFlags(plate.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
        plate.setActivationState(DISABLE_DEACTIVATION);
        rig.world().addRigidBody(&plate);
        if (withSlowSheet) {
            auto slow = test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.3, 8, 5);
            slow->translate({5, 0, 0});
            slow->m_cfg.timescale = btScalar(0.1);
            rig.cover(rig.add(std::move(slow)), fabrics::cottonPlain());
        }
        btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.5, 13, 0.04));
        rig.cover(sheet, fabrics::cottonPlain());
        for (int frame = 1; frame <= 60; ++frame) {
            plate.setWorldTransform(btTransform(btQuaternion::getIdentity(), {0, btScalar(frame / 60.0), 0}));
            rig.run(1.0 / 60);
        }
        const double height = test::lowest(sheet);
        rig.world().removeRigidBody(&plate);
        return height;
    };
    EXPECT_GT(lifted(false), 1.0);
    EXPECT_NEAR(lifted(true), lifted(false), 2e-3);
}

TEST(SmallStepTouch, HealthKnowsThatBulletMovesTheSheetAgain) {
    test::SmallStepWorld rig;
    btSoftBody& sheet = rig.add(test::smallSheet(rig.info()));
    const WetCloth& cloth = rig.cover(sheet, fabrics::cottonPlain());
    rig.run(0.1);
    EXPECT_GT(cloth.health().smallSteps, 0);
    sheet.setPose(false, true);
    sheet.m_cfg.kMT = btScalar(0.01);  // pose matching goes Bullet's way
    rig.run(0.1);
    EXPECT_EQ(cloth.health().smallSteps, 0);
}

TEST(SmallStepTouch, SettingsOutOfRangeAreRefused) {
    for (const int count : {-1, 1001}) {
        SmallStepSettings settings;
        settings.count = count;
        EXPECT_THROW(SmallStepSolver{settings}, std::invalid_argument) << count;
    }
    for (const double tolerance : {0.0, -1.0, 2.0, std::numeric_limits<double>::quiet_NaN()}) {
        SmallStepSettings settings;
        settings.stretchTolerance = tolerance;
        EXPECT_THROW(SmallStepSolver{settings}, std::invalid_argument) << tolerance;
    }
}

}  // namespace
}  // namespace drench::small_step_touch_test
