// Friction and adhesion of one contact, against closed forms.
#include "bullet/contact/contact_law.h"

#include <BulletSoftBody/btSoftBody.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "bullet/contact/flat_neighbours.h"

namespace drench::contact_law_test {
namespace {

constexpr double g = 9.81;
constexpr double step = 1e-3, mass = 0.3, seconds = 0.5;

// A block on a slope, by impulses. There is no way but along the slope; the normal is z.
class Block {
  public:
    Block(double angle, double friction, double adhesion)
        : gravity_(btScalar(g * std::sin(angle)), 0, btScalar(-g * std::cos(angle))),
          law_{btScalar(friction), btScalar(adhesion * step)} {}

    void run(double time) {
        const btVector3 normal(0, 0, 1);
        for (int i = 0; i < int(std::lround(time / step)); ++i) {
            velocity_ += gravity_ * btScalar(step);
            const btScalar push = law_.push(btScalar(-mass) * velocity_.dot(normal));
            const btVector3 slip = alongSurface(velocity_, normal);
            btVector3 impulse = normal * push;
            if (slip.length() > 0)
                impulse -= drag(slip, slip.length(), btScalar(mass) * slip.length(), law_.maxFriction(push));
            velocity_ += impulse / btScalar(mass);
        }
    }
    double downhill() const { return double(velocity_.x()); }
    double offTheSlope() const { return double(velocity_.z()); }

  private:
    btVector3 gravity_;
    btVector3 velocity_ = {0, 0, 0};
    ContactLaw law_;
};

TEST(ContactLaw, ABlockSlipsWhereTheSlopeIsSteeperThanItsFriction) {
    for (const double friction : {0.05, 0.3, 1.0, 5.0}) {
        const double steepest = std::atan(friction);
        Block holds(steepest * 0.999, friction, 0), slips(steepest * 1.001, friction, 0);
        holds.run(seconds);
        slips.run(seconds);
        EXPECT_NEAR(holds.downhill(), 0, 1e-6) << friction;
        EXPECT_GT(slips.downhill(), 1e-5) << friction;
        EXPECT_NEAR(slips.offTheSlope(), 0, 1e-6) << friction;
    }
}

TEST(ContactLaw, ASlidingBlockHasTheSpeedOfCoulombsFriction) {
    for (const double friction : {0.0, 0.2, 0.4}) {
        constexpr double angle = 0.6;
        Block block(angle, friction, 0);
        block.run(seconds);
        EXPECT_NEAR(block.downhill(), g * (std::sin(angle) - friction * std::cos(angle)) * seconds, 1e-4);
    }
}

TEST(ContactLaw, AdhesionHoldsABlockUnderACeiling) {
    constexpr double upsideDown = 3.14159265358979;
    Block holds(upsideDown, 0, mass * g * 1.001), falls(upsideDown, 0, mass * g * 0.9),
        without(upsideDown, 0, 0);
    for (Block* block : {&holds, &falls, &without}) block->run(seconds);
    EXPECT_NEAR(holds.offTheSlope(), 0, 1e-6);
    EXPECT_NEAR(falls.offTheSlope(), 0.1 * g * seconds, 1e-4);
    EXPECT_NEAR(without.offTheSlope(), g * seconds, 1e-4);
}

TEST(ContactLaw, AdhesionPressesLikeALoad) {
    // On a wall nothing presses but the bond: friction x adhesion against the weight.
    constexpr double wall = 3.14159265358979 / 2, friction = 0.5;
    Block holds(wall, friction, mass * g / friction * 1.001),
        slips(wall, friction, mass * g / friction * 0.8);
    holds.run(seconds);
    slips.run(seconds);
    EXPECT_NEAR(holds.downhill(), 0, 1e-6);
    EXPECT_NEAR(slips.downhill(), 0.2 * g * seconds, 1e-4);
    // A bond that is pulled with all it holds has nothing left that would press.
    const ContactLaw law = {btScalar(friction), 2};
    EXPECT_EQ(law.maxFriction(law.push(-5)), 0);
    EXPECT_EQ(law.maxFriction(law.push(0)), 1);
    EXPECT_EQ(law.maxFriction(law.push(3)), btScalar(2.5));
}

TEST(ContactLaw, NothingPullsWithoutABond) {
    const ContactLaw law = {1, 0};
    for (const double needed : {-1e9, -1.0, -1e-9}) EXPECT_EQ(law.push(btScalar(needed)), 0);
    EXPECT_EQ(law.push(7), 7);
    EXPECT_EQ(law.maxFriction(0), 0);
}

TEST(ContactLaw, FrictionNeverAcceleratesNorTurnsTheSlipRound) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    const auto vector = [&] {
        return btVector3(btScalar(any(random)), btScalar(any(random)), btScalar(any(random)));
    };
    for (int i = 0; i < 2000; ++i) {
        const btVector3 normal = vector().normalized(), slip = alongSurface(vector(), normal);
        EXPECT_NEAR(double(slip.dot(normal)), 0, 1e-6);
        const btScalar length = slip.length();
        if (!(length > 0)) continue;
        const ContactLaw law = {btScalar(std::pow(10, 3 * any(random))), btScalar(any(random) > 0 ? 0.5 : 0)};
        const btScalar push = law.push(btScalar(any(random)));
        const btVector3 left = slip - drag(slip, length, length, law.maxFriction(push));
        EXPECT_LE(double(left.length()), double(length) * (1 + 1e-6));
        EXPECT_GE(double(left.dot(slip)), -1e-6 * double(length * length));
    }
}

TEST(ContactLaw, ABondFormsOnTouchAndBreaksWhereItsReachEnds) {
    constexpr double reach = 0.01;
    EXPECT_FALSE(adhesionHolds(1, false, 0.001, reach)) << "has not touched";
    EXPECT_TRUE(adhesionHolds(1, true, -0.001, reach));
    EXPECT_TRUE(adhesionHolds(1, true, 0.0099, reach));
    EXPECT_FALSE(adhesionHolds(1, true, 0.01, reach));
    EXPECT_FALSE(adhesionHolds(0, true, -0.001, reach)) << "is dry";
    EXPECT_FALSE(adhesionHolds(1, true, std::numeric_limits<double>::quiet_NaN(), reach));
}

TEST(ContactLaw, ToPullANodeOffTakesForceTimesReach) {
    constexpr double reach = 0.01, force = 0.2, distance = 1e-5;
    const ContactLaw law = {0, btScalar(force)};
    double work = 0;
    bool adheres = true;
    for (double gap = distance / 2; adheres; gap += distance) {
        adheres = adhesionHolds(force, adheres, gap, reach);
        if (adheres) work -= double(law.push(-1e6)) * distance;
    }
    EXPECT_NEAR(work, force * reach, 1e-3 * force * reach);
}

TEST(ContactLaw, TwoClothsHoldAsTheDrierOneDoesFromEitherSideHalf) {
    EXPECT_EQ(adhesionTractionBetween(8, 8) + adhesionTractionBetween(8, 8), 8);
    EXPECT_EQ(adhesionTractionBetween(8, 2), 1);
    EXPECT_EQ(adhesionTractionBetween(0, 8), 0);
}

TEST(ContactLaw, CoefficientsThatAreNegativeOrNaNCountAsZero) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                     infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(usableFriction(0.4), 0.4);
    EXPECT_EQ(usableFriction(-0.4), 0);
    EXPECT_EQ(usableFriction(nan), 0);
    EXPECT_EQ(usableFriction(-infinity), 0);
    EXPECT_EQ(usableFriction(infinity), 1000);
}

TEST(ContactLaw, TwoClothsRubByTheRougherOne) {
    btSoftBodyWorldInfo info;
    btSoftBody one(&info), other(&info);
    one.m_cfg.kDF = btScalar(0.2);
    other.m_cfg.kDF = btScalar(0.5);
    EXPECT_EQ(dryFriction(one, other), btScalar(0.5));
    EXPECT_EQ(dryFriction(other, one), btScalar(0.5));
    other.m_cfg.kDF = -1;
    one.m_cfg.kDF = -2;
    EXPECT_EQ(dryFriction(one, other), 0);
    one.m_cfg.kDF = std::numeric_limits<btScalar>::infinity();
    EXPECT_EQ(dryFriction(one, other), 1000);
}

TEST(ContactLaw, OverlappingClothsComeApartByATenthOfTheirMarginAtOnce) {
    EXPECT_EQ(liftAtOnce(0.5, 20.0), 0.5);
    EXPECT_EQ(liftAtOnce(5.0, 20.0), 2.0);
}

TEST(FlatNeighbours, CountWhereTheyRiseOrFaceAnotherWay) {
    EXPECT_FALSE(risesAbove(0, 1));
    EXPECT_FALSE(risesAbove(btScalar(0.09), 1));
    EXPECT_TRUE(risesAbove(btScalar(0.11), 1));
    const btVector3 up(0, 1, 0);
    const auto leaning = [](double degrees) {
        const double angle = degrees * 3.14159265358979 / 180;
        return btVector3(btScalar(std::sin(angle)), btScalar(std::cos(angle)), 0);
    };
    EXPECT_TRUE(faceAlike(up, leaning(45)));
    EXPECT_FALSE(faceAlike(up, leaning(46)));
    EXPECT_FALSE(faceAlike(up, -up));
}

}  // namespace
}  // namespace drench::contact_law_test
