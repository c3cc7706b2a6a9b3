// Wet friction and cling of sheets that a SmallStepSolver moves.
#include <gtest/gtest.h>

#include <string>

#include "bullet/world/worlds.h"

namespace drench::friction_test {
namespace {

constexpr double g = 9.81;
constexpr double slopeAngle = 20 * 3.14159265358979 / 180;

// Layers in here are stepped by the test, and once only, so that water stays where it is and there is no air.

// Velocity down a slope of 20 degrees after 2 s, of cloth with so much water, kg/m2.
double slideWet(const Fabric& fabric, double water, const Surface& surface) {
    test::SmallStepWorld rig;
    const btTransform slope(btQuaternion({0, 0, 1}, btScalar(slopeAngle)), {0, 0, 0});
    btRigidBody& box = rig.bullet().addBox({0, 0, 0}, {8, btScalar(0.5), 2});
    box.setWorldTransform(slope);
    rig.world().updateAabbs();
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 0.5, 13, 0));
    const btScalar margin = sheet.getCollisionShape()->getMargin();
    sheet.transform(btTransform(slope.getRotation(), slope * btVector3(6, btScalar(0.5) + margin, 0)));
    WetCloth& cloth = rig.cover(sheet, fabric, test::withoutAir());
    cloth.air().vapourExchange = 0;
    cloth.setSurface(box, surface);
    rig.run(1.0 / 60);  // so that it lies, and does not drip
    test::setVelocity(sheet, {0, 0, 0});
    cloth.soakPores(water);
    cloth.preSubstep(btScalar(1e-6));
    rig.run(2);
    const btVector3 down = slope.getBasis() * btVector3(-1, 0, 0);
    return double(test::momentum(sheet).dot(down)) / test::mass(sheet);
}

double slidingSpeed(double friction) {
    return 2 * g * (std::sin(slopeAngle) - friction * std::cos(slopeAngle));
}

TEST(Friction, FrictionFollowsTheWaterOnASlope) {
    Fabric fabric = fabrics::polyesterPlain();
    fabric.clingEnergy = 0;  // friction alone
    const Surface plate = surfaceOf(fabric, SurfaceKind::plate);
    const double full = fabric.poreCapacity(), film = 2 * waterDensity * 0.15e-3;
    EXPECT_NEAR(slideWet(fabric, 0, plate) / slidingSpeed(0.2), 1, 0.03);
    EXPECT_NEAR(slideWet(fabric, 0.6 * full, plate), 0, 1e-3);
    EXPECT_NEAR(slideWet(fabric, full + film, plate) / slidingSpeed(0.3), 1, 0.03);
    EXPECT_NEAR(slideWet(fabric, full + film, surfaceOf(fabric, SurfaceKind::skin)), 0, 1e-3);
}

TEST(Friction, ClingHoldsOnASlopeWhatFrictionAloneWouldNot) {
    Fabric fabric = fabrics::cottonPlain();
    const Surface slippery = {0.1, 0.1, 0.1, 1}, repelling = {0.1, 0.1, 0.1, 0};
    const double damp = 0.6 * fabric.poreCapacity();
    EXPECT_NEAR(slideWet(fabric, damp, slippery), 0, 1e-3);
    EXPECT_NEAR(slideWet(fabric, damp, repelling) / slidingSpeed(0.1), 1, 0.03);
    EXPECT_NEAR(slideWet(fabric, 0, slippery) / slidingSpeed(0.1), 1, 0.03);
    // Dripping: 0.25 mm of film on each face.
    EXPECT_NEAR(slideWet(fabric, fabric.poreCapacity() + 0.5, slippery) / slidingSpeed(0.1), 1, 0.03);
}

// How far a sheet that touches a ceiling has come down after a second, m.
double fallFromCeiling(double clingOverWeight, double wettability, SmallStepSettings steps) {
    Fabric fabric = fabrics::cottonPlain();
    constexpr int nodes = 21;
    constexpr double side = 0.1;
    const double water = 0.6 * fabric.poreCapacity();
    test::SmallStepWorld rig(steps);
    btRigidBody& ceiling = rig.bullet().addBox({0, btScalar(0.5), 0}, {1, btScalar(0.5), 1});
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, side, nodes, 0));
    // A bond reaches as far as from node to node: the root of the area of each.
    fabric.clingEnergy = clingOverWeight * (fabric.arealDensity + water) * g * side / nodes;
    sheet.translate({0, -sheet.getCollisionShape()->getMargin() + btScalar(1e-4), 0});
    const double start = test::lowest(sheet);
    WetCloth& cloth = rig.cover(sheet, fabric, test::withoutAir());
    cloth.soakPores(water);
    cloth.setSurface(ceiling, {0.3, 0.3, 0.3, wettability});
    cloth.preSubstep(btScalar(1e-6));
    rig.run(1);
    return start - test::lowest(sheet);
}

TEST(Friction, AWetSheetHangsFromACeilingAsLongAsClingExceedsItsWeight) {
    for (const int steps : {4, 0}) {
        EXPECT_LT(fallFromCeiling(1.05, 1, {steps, 0.01}), 1e-3);
        EXPECT_GT(fallFromCeiling(0.95, 1, {steps, 0.01}), 1);
        EXPECT_GT(fallFromCeiling(1.9, 0.5, {steps, 0.01}), 1);
    }
}

// A sheet of wet cloth that lies on a free plate without gravity, to be pulled off.
class Peel {
  public:
    static constexpr double length = 0.3, width = 0.05, plateMass = 20;

    Peel(double spacing, double clingEnergy, SmallStepSettings steps) : rig_(steps) {
        Fabric fabric = fabrics::cottonPlain();
        fabric.clingEnergy = clingEnergy;
        rig_.setGravity({0, 0, 0});
        plate_ = &rig_.bullet().addBall({0, btScalar(-0.5), 0}, 0.5, plateMass);  // its shape is replaced
        plate_->setCollisionShape(&shape_);
        plate_->setAngularFactor(0);
        plate_->setActivationState(DISABLE_DEACTIVATION);
        along_ = int(std::lround(length / spacing)) + 1;
        across_ = int(std::lround(width / spacing)) + 1;
        sheet_ = &rig_.add(makeSheet(
            rig_.info(), fabric, flatCorners({0, 0, 0}, {btScalar(length), 0, 0}, {0, 0, btScalar(width)}),
            along_, across_));
        sheet_->translate({0, sheet_->getCollisionShape()->getMargin() - btScalar(1e-4), 0});
        WetCloth& cloth = rig_.cover(*sheet_, fabric, test::withoutAir());
        cloth.soakPores(0.6 * fabric.poreCapacity());
        cloth.setSurface(*plate_, {1, 1, 1, 1});
        cloth.preSubstep(btScalar(1e-6));
        rig_.run(0.1);
    }

    // Takes hold of one end.
    void hold(const btVector3& velocity) {
        for (int j = 0; j < across_; ++j) {
            btSoftBody::Node& node = sheet_->m_nodes[j * along_];
            node.m_im = 0;
            node.m_v = velocity;
        }
    }
    void throwUp(double speed) { test::setVelocity(*sheet_, {0, btScalar(speed), 0}); }
    double mass() const { return test::mass(*sheet_); }
    // Upwards, on average.
    double speed() const { return double(test::momentum(*sheet_).y()) / mass(); }

    // Impulse upwards on the plate, by the cloth, while so much time passes, N s.
    double pull(double time) {
        const double before = double(plate_->getLinearVelocity().y());
        rig_.run(time);
        return plateMass * (double(plate_->getLinearVelocity().y()) - before);
    }

  private:
    btBoxShape shape_ = btBoxShape({1, btScalar(0.5), 1});
    test::SmallStepWorld rig_;
    btRigidBody* plate_;
    btSoftBody* sheet_;
    int along_, across_;
};

TEST(Friction, PeelingAStripAtARightAngleTakesItsEnergyPerLength) {
    constexpr double energy = 0.13, speed = 0.05;
    for (const double spacing : {0.01, 0.005})
        for (const int steps : {20, 0}) {
            Peel strip(spacing, energy, {steps, 0.01});
            strip.hold({btScalar(speed), btScalar(speed), 0});
            strip.pull(1.0);
            const double force = strip.pull(3.0) / 3.0;
            EXPECT_NEAR(force / (energy * Peel::width), 1, 0.15) << spacing << " m, " << steps << " steps";
        }
}

TEST(Friction, ASheetThatFliesOffAPlateHasLostTheEnergyOfItsBonds) {
    for (const double energy : {0.02, 0.13}) {
        Peel sheet(0.01, energy, {0, 0.01});
        const double arealMass = sheet.mass() / (Peel::width * Peel::length);
        const double min = std::sqrt(2 * energy / arealMass);
        sheet.throwUp(1.5 * min);
        sheet.pull(0.2);
        const double left = sheet.speed();
        EXPECT_NEAR(arealMass / 2 * (2.25 * min * min - left * left) / energy, 1, 0.2);

        Peel tooSlow(0.01, energy, {0, 0.01});
        tooSlow.throwUp(0.9 * min);
        tooSlow.pull(0.5);
        EXPECT_NEAR(tooSlow.speed(), 0, 0.05 * min);
    }
}

// How far a piece of cloth under another one, which is held everywhere, has come down after half a second, m.
double fallFromCloth(double clingOverWeight, bool isUpperWet, bool isLowerWet) {
    constexpr double spacing = 0.01;
    constexpr int nodes = 13, nodesAbove = 25;
    Fabric fabric = fabrics::cottonPlain();
    const double water = 0.6 * fabric.poreCapacity();
    fabric.clingEnergy = clingOverWeight * (fabric.arealDensity + water) * g * spacing;
    test::SmallStepWorld rig;
    btSoftBody& upper =
        rig.add(test::levelSheet(rig.info(), fabric, spacing * (nodesAbove - 1), nodesAbove, 0));
    for (int n = 0; n < upper.m_nodes.size(); ++n) upper.m_nodes[n].m_im = 0;
    btSoftBody& lower = rig.add(test::levelSheet(rig.info(), fabric, spacing * (nodes - 1), nodes, 0));
    // Not node under node.
    lower.translate(
        {btScalar(0.003), -2 * lower.getCollisionShape()->getMargin() + btScalar(1e-4), btScalar(0.002)});
    const double start = test::lowest(lower);
    for (btSoftBody* body : {&upper, &lower}) {
        body->m_cfg.collisions |= btSoftBody::fCollision::VF_SS;
        WetCloth& cloth = rig.cover(*body, fabric, test::withoutAir());
        if (body == &upper ? isUpperWet : isLowerWet) cloth.soakPores(water);
        cloth.preSubstep(btScalar(1e-6));
    }
    rig.run(0.5);
    return start - test::lowest(lower);
}

TEST(Friction, WetClothHangsOnWetCloth) {
    EXPECT_LT(fallFromCloth(1.3, true, true), 2e-3);
    EXPECT_GT(fallFromCloth(0.7, true, true), 0.5);
    EXPECT_GT(fallFromCloth(5, true, false), 0.5);
    EXPECT_GT(fallFromCloth(5, false, true), 0.5);
}

TEST(Friction, ClothSlidesOnClothAsOnAPlate) {
    for (const double friction : {0.0, 0.2}) {
        const Fabric fabric = fabrics::cottonPlain();
        test::SmallStepWorld rig;
        btSoftBody& lower = rig.add(test::levelSheet(rig.info(), fabric, 1, 41, 0));
        for (int n = 0; n < lower.m_nodes.size(); ++n) lower.m_nodes[n].m_im = 0;
        btSoftBody& upper = rig.add(test::levelSheet(rig.info(), fabric, 0.2, 17, 0));
        const btQuaternion slope({0, 0, 1}, btScalar(slopeAngle));
        const btScalar apart =
            lower.getCollisionShape()->getMargin() + upper.getCollisionShape()->getMargin();
        lower.transform(btTransform(slope, {0, 0, 0}));
        upper.transform(btTransform(slope, quatRotate(slope, {btScalar(0.3), apart, 0})));
        for (btSoftBody* body : {&lower, &upper}) {
            body->m_cfg.collisions |= btSoftBody::fCollision::VF_SS;
            body->m_cfg.kDF = btScalar(friction);
            rig.cover(*body, fabric, test::withoutAir());
        }
        rig.run(0.4);
        const btVector3 down = quatRotate(slope, {-1, 0, 0});
        const double speed = double(test::momentum(upper).dot(down)) / test::mass(upper);
        EXPECT_NEAR(speed / (0.2 * slidingSpeed(friction)), 1, 0.05) << friction;
    }
}

// How far a piece of cloth on a ball has got from the place on the ball where it lay, after the ball has turned upside
// down and further about a level axis, m.
double leftBehind(double fractionOfSaturation) {
    constexpr double radius = 0.2, angularAcceleration = 4;
    const Fabric fabric = fabrics::cottonPlain();
    test::SmallStepWorld rig;
    btRigidBody& ball = rig.bullet().addBall({0, 0, 0}, radius, 0);
    ball.setCollisionFlags(ball.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    ball.setActivationState(DISABLE_DEACTIVATION);
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 0.2, 21, radius + 0.006));
    WetCloth& cloth = rig.cover(sheet, fabric);
    cloth.air().vapourExchange = 0;
    cloth.soakPores(fractionOfSaturation * fabric.poreCapacity());
    cloth.setSurface(ball, SurfaceKind::plate);
    rig.run(0.5);
    const btVector3& middle = sheet.m_nodes[sheet.m_nodes.size() / 2].m_x;
    const btVector3 start = middle;
    double angle = 0;
    for (int frame = 1; frame <= 90; ++frame) {
        angle = angularAcceleration / 2 * frame * frame / 3600;
        ball.setWorldTransform(btTransform(btQuaternion({0, 0, 1}, btScalar(-angle)), {0, 0, 0}));
        rig.run(1.0 / 60);
    }
    // Nodes lie above the surface by the margin, and go with its speed.
    const btScalar turned = btScalar(angle * radius) / start.length();
    return double((middle - start.rotate({0, 0, 1}, -turned)).length());
}

TEST(Friction, ATurningBallCarriesWetClothRound) {
    EXPECT_LT(leftBehind(0.6), 0.01);
    EXPECT_GT(leftBehind(0), 0.3);
}

}  // namespace
}  // namespace drench::friction_test
