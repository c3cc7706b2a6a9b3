// How far cloth stands out over an edge under its own weight, against the elastica solved here on its own.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "bullet/world/worlds.h"

namespace drench::cantilever_test {
namespace {

constexpr double gravity = 9.81;
constexpr double degree = 3.14159265358979 / 180;

// A beam that is clamped level at one end and bends under its own weight: inextensible, of any law of bending,
// in steps from its free end, where there is no moment.
class Elastica {
  public:
    // Curvature, 1/m, under a moment per width, N, at a place counted from the free end.
    using Law = std::function<double(int point, double moment)>;

    Elastica(double length, Law law) : step_(length / points), law_(std::move(law)), moments_(points) {}

    // Drop of the tip as an angle, seen from the clamp, rad.
    double tipAngle(double weight) {
        // The steeper the tip, the steeper the other end: the one for which the clamp is level.
        double low = 0, high = 90 * degree;
        for (int i = 0; i < 60; ++i) {
            const double middle = (low + high) / 2;
            (slopeAtClamp(middle, weight) > 0 ? high : low) = middle;
        }
        slopeAtClamp(low, weight);
        return std::atan2(drop_, reach_);
    }
    double moment(int point) const { return moments_[std::size_t(point)]; }

    static constexpr int points = 400;

  private:
    // Integrates M' = w t cos(slope), slope' = -curvature(M) from the tip, by the midpoint rule.
    double slopeAtClamp(double tip, double weight) {
        double slope = tip, moment = 0;
        reach_ = drop_ = 0;
        for (int point = 0; point < points; ++point) {
            const double t = point * step_;
            const double halfMoment = moment + step_ / 2 * weight * (t + step_ / 4) * std::cos(slope);
            const double curvature = law_(point, halfMoment);
            const double halfSlope = slope - step_ / 2 * curvature;
            moments_[std::size_t(point)] = halfMoment;
            moment += step_ * weight * (t + step_ / 2) * std::cos(halfSlope);
            reach_ += step_ * std::cos(halfSlope);
            drop_ += step_ * std::sin(halfSlope);
            slope -= step_ * curvature;
        }
        return slope;
    }

    double step_;
    Law law_;
    std::vector<double> moments_;  // of the last integration, at each place
    double reach_ = 0, drop_ = 0;
};

// Angle under which the tip of an overhang of `length` bending lengths hangs.
double elasticTipAngle(double length) {
    return Elastica(length, [](int, double moment) { return moment; }).tipAngle(1);
}

// The bending length of cloth of which an overhang of `length` hangs under `angle`.
double bendingLength(double length, double angle) {
    double low = length / 6, high = length * 3;
    for (int i = 0; i < 50; ++i) {
        const double middle = (low + high) / 2;
        (elasticTipAngle(length / middle) > angle ? low : high) = middle;
    }
    return low;
}

double theory(double bending, double arealDensity) {
    return std::cbrt(bending / (arealDensity * gravity));
}

enum class Direction { warp, weft };

constexpr int freeColumns = 10, columns = freeColumns + 2, rows = 3;

int nodeAt(Direction along, int column, int row) {
    return along == Direction::warp ? column + columns * row : row + rows * column;
}

// Two held columns hold the cloth level half-way between them.
double cellOf(double overhang) {
    return overhang / (freeColumns + 0.5);
}

// A strip in a world, its first two columns held level.
class Strip {
  public:
    Strip(const Fabric& fabric, double overhang, Direction along, int steps = 100)
        : along_(along), cell_(cellOf(overhang)), rig_({steps, 0.01}) {
        const btVector3 length(btScalar(cell_ * (columns - 1)), 0, 0), width(0, 0, btScalar(2 * cell_));
        const bool isWarp = along == Direction::warp;
        body_ = &rig_.add(makeSheet(rig_.info(), fabric,
                                    flatCorners({0, 0, 0}, isWarp ? length : width, isWarp ? width : length),
                                    isWarp ? columns : rows, isWarp ? rows : columns));
        for (int row = 0; row < rows; ++row)
            for (const int column : {0, 1}) body_->m_nodes[nodeAt(along, column, row)].m_im = 0;
        SheetSettings settings;
        settings.waterSpeed = 0;  // water stays where it is
        cloth_ = &rig_.cover(*body_, fabric, settings);
        body_->m_cfg.kDP = 15;
    }

    WetCloth& cloth() { return *cloth_; }
    void setGravity(double strength) { rig_.setGravity({0, btScalar(-strength), 0}); }
    void run(double time) { rig_.run(time); }
    double tipAngle() const {
        const btVector3& tip = body_->m_nodes[nodeAt(along_, columns - 1, 1)].m_x;
        return std::atan2(-double(tip.y()), double(tip.x()) - cell_ / 2);
    }

  private:
    Direction along_;
    double cell_;
    test::SmallStepWorld rig_;
    btSoftBody* body_;
    WetCloth* cloth_;
};

Fabric bendable(double bending, double arealDensity) {
    Fabric fabric = fabrics::cottonPlain();
    fabric.bending = bending;
    fabric.bendingFriction = 0;
    fabric.arealDensity = arealDensity;
    return fabric;
}

TEST(Cantilever, TheElasticaOfTwoBendingLengthsHangsAsPeirceFound) {
    EXPECT_NEAR(elasticTipAngle(2) / degree, 41.5, 0.5);
    // Short ones sag as a beam of small deflection: w L^4 / (8 B).
    EXPECT_NEAR(elasticTipAngle(0.2), std::pow(0.2, 3) / 8, 1e-5);
}

struct Cloth {
    double bending, arealDensity;
};

class BendingLength : public testing::TestWithParam<std::tuple<Cloth, Direction>> {};

TEST_P(BendingLength, IsThatOfRigidityAndWeight) {
    const auto& [cloth, along] = GetParam();
    const double expected = theory(cloth.bending, cloth.arealDensity), overhang = 2 * expected;
    Strip strip(bendable(cloth.bending, cloth.arealDensity), overhang, along);
    strip.run(3);
    const double found = bendingLength(overhang, strip.tipAngle());
    EXPECT_NEAR(found / expected, 1, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Cloths, BendingLength,
                         testing::Combine(testing::Values(Cloth{1.16e-5, 0.150}, Cloth{7.55e-6, 0.1165},
                                                          Cloth{1e-6, 0.070}, Cloth{1e-4, 0.324}),
                                          testing::Values(Direction::warp, Direction::weft)));

TEST(Cantilever, SoakedClothBendsOverAShorterLength) {
    const Fabric fabric = bendable(fabrics::cottonPlain().bending, 0.150);
    constexpr double moistureContent = 1.5;  // kg/kg
    const double expected = theory(fabric.bending * WetLaws(fabric).bendingRatio(moistureContent),
                                   fabric.arealDensity * (1 + moistureContent));
    ASSERT_LT(expected, 0.7 * theory(fabric.bending, fabric.arealDensity));
    for (const Direction along : {Direction::warp, Direction::weft}) {
        Strip strip(fabric, 2 * expected, along);
        strip.cloth().soakPores(moistureContent * fabric.arealDensity);
        strip.run(3);
        const double found = bendingLength(2 * expected, strip.tipAngle());
        EXPECT_NEAR(found / expected, 1, 0.05);
    }
}

// Cloth with friction beside its rigidity, bent at each place as its history has left it: the friction holds
// twice as stiff as the cloth bends until it slides.
class FrictionalElastica {
  public:
    FrictionalElastica(double length, double bending, double friction)
        : bending_(bending),
          friction_(friction),
          slid_(Elastica::points, 0.0),
          elastica_(length, [this](int point, double moment) { return curvature(point, moment); }) {}

    // Lets the weight per area go there slowly.
    double tipAngleAt(double weight) {
        constexpr int steps = 60;
        const double from = weight_;
        double angle = 0;
        for (int i = 1; i <= steps; ++i) {
            weight_ = from + (weight - from) * i / steps;
            angle = elastica_.tipAngle(weight_);
            for (int point = 0; point < Elastica::points; ++point) slide(point);
        }
        return angle;
    }

  private:
    double curvature(int point, double moment) const {
        const double held =
            (moment + stiffer * bending_ * slid_[std::size_t(point)]) / ((1 + stiffer) * bending_);
        const double carried = stiffer * bending_ * (held - slid_[std::size_t(point)]);
        if (std::abs(carried) <= friction_) return held;
        return (moment - std::copysign(friction_, carried)) / bending_;
    }
    void slide(int point) {
        double& slid = slid_[std::size_t(point)];
        const double bent = curvature(point, elastica_.moment(point)), max = friction_ / (stiffer * bending_);
        slid = std::clamp(slid, bent - max, bent + max);
    }

    static constexpr double stiffer = 2;
    double bending_, friction_;
    double weight_ = 0;
    std::vector<double> slid_;
    Elastica elastica_;
};

// Tip angles on the way down, and on the way back from four times the weight.
struct Loop {
    double down, back;
};

Loop loopOfTheory(const Fabric& fabric, double length) {
    FrictionalElastica elastica(length, fabric.bending, fabric.bendingFriction);
    const double weight = fabric.arealDensity * gravity;
    Loop loop{};
    loop.down = elastica.tipAngleAt(weight);
    elastica.tipAngleAt(4 * weight);
    loop.back = elastica.tipAngleAt(weight);
    return loop;
}

Loop loopOfStrip(const Fabric& fabric, double length, Direction along) {
    // While its friction holds cloth is three times as stiff, and takes shorter steps.
    Strip strip(fabric, length, along, 300);
    const auto change = [&strip](double from, double to) {
        constexpr int frames = 60;
        for (int i = 1; i <= frames; ++i) {
            strip.setGravity(from + (to - from) * i / frames);
            strip.run(1.0 / 60);
        }
        strip.run(0.5);
    };
    Loop loop{};
    change(0, gravity);
    loop.down = strip.tipAngle();
    change(gravity, 4 * gravity);
    change(4 * gravity, gravity);
    loop.back = strip.tipAngle();
    return loop;
}

TEST(Cantilever, FrictionHoldsClothStraighterOnTheWayDownAndMoreBentOnTheWayBack) {
    Fabric fabric = bendable(fabrics::cottonPlain().bending, 0.150);
    const double length = 2 * theory(fabric.bending, fabric.arealDensity);
    const double clampMoment = fabric.arealDensity * gravity * length * length / 2;
    for (const double fraction : {0.075, 0.25})
        for (const Direction along : {Direction::warp, Direction::weft}) {
            fabric.bendingFriction = fraction * clampMoment;
            const Loop expected = loopOfTheory(fabric, length), found = loopOfStrip(fabric, length, along);
            SCOPED_TRACE("friction " + std::to_string(fabric.bendingFriction));
            ASSERT_GT(expected.back, expected.down + 5 * degree);
            EXPECT_NEAR(found.down / expected.down, 1, 0.05);
            EXPECT_NEAR(found.back / expected.back, 1, 0.05);
            EXPECT_NEAR((found.back - found.down) / (expected.back - expected.down), 1, 0.15);
        }
}

}  // namespace
}  // namespace drench::cantilever_test
