#include "drench/sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include "sheet_stand_in.h"

namespace drench::rain_test {
namespace {

using Eigen::Vector3d;
using test::Cloth;
using test::expectCount;
using test::expectRange;
using test::expectRefusal;
using test::nan;
using test::run;

// A flat roof at a height, endless but for x below its edge.
std::function<bool(const Vector3d&, const Vector3d&)> roof(double height, double edge) {
    return [=](const Vector3d& from, const Vector3d& to) {
        const double fraction = (height - from.y()) / (to.y() - from.y());
        return fraction > 0 && fraction < 1 && (from + fraction * (to - from)).x() > edge;
    };
}

// Three standard deviations of a mass that falls in single drops, kg.
double threeSigma(double mass, double drop) {
    return 3 * std::sqrt(mass * drop);
}

TEST(SheetPose, AreaVectorsAreThirdsOfTheTrianglesAsTheyAreNow) {
    Cloth cloth(1, 4);
    cloth.move([](const Vector3d& p) { return Vector3d(2 * p.x(), 0, p.z()); });
    Vector3d sum = Vector3d::Zero();
    for (std::size_t node = 0; node < cloth.mesh.size(); ++node) {
        EXPECT_NEAR(cloth.pose().areaVector(node).y(), 2 * cloth.mesh.areas[node], 1e-15);
        sum += cloth.pose().areaVector(node);
    }
    EXPECT_NEAR((sum - Vector3d(0, 2, 0)).norm(), 0, 1e-12);
}

TEST(Rain, BringsItsIntensityToALevelSheet) {
    // 1 mm on 1 m2 is 1 kg. The step is in seconds, as water time may run fast.
    Cloth cloth(1, 20);
    Rain rain(1);
    run(rain, cloth, 1, 3600);
    EXPECT_NEAR(cloth.film(), 1, threeSigma(1, rain.dropMass));
}

TEST(Rain, CatchesWhatATiltedSheetStandsAcross) {
    const double slope = std::sqrt(0.5);
    Cloth tilted(1, 20), upright(1, 20);
    tilted.move([&](const Vector3d& p) { return Vector3d(slope * p.x(), slope * p.x(), p.z()); });
    upright.move([](const Vector3d& p) { return Vector3d(0, p.x(), p.z()); });
    Rain rain(1);
    run(rain, tilted, 1, 3600);
    EXPECT_NEAR(tilted.film(), slope, threeSigma(slope, rain.dropMass));
    run(rain, upright, 1, 3600);
    EXPECT_EQ(upright.film(), 0);
}

TEST(Rain, CatchesMoreOnAStretchedSheetUpToHalfAsMuchAgain) {
    for (const double stretch : {1.25, 2.0}) {
        Cloth cloth(1, 20);
        cloth.move([&](const Vector3d& p) { return Vector3d(stretch * p.x(), 0, p.z()); });
        Rain rain(1);
        run(rain, cloth, 1, 3600);
        const double expected = std::min(stretch, 1.5);
        EXPECT_NEAR(cloth.film(), expected, threeSigma(expected, rain.dropMass)) << stretch;
    }
}

TEST(Rain, SlantedBringsAsMuchToLevelGroundAndMoreToAWall) {
    Cloth level(1, 20), wall(1, 20);
    wall.move([](const Vector3d& p) { return Vector3d(0, p.x(), p.z()); });
    Rain rain(1);
    rain.velocity = {13, -6.5, 0};
    run(rain, level, 1, 3600);
    EXPECT_NEAR(level.film(), 1, threeSigma(1, rain.dropMass));
    run(rain, wall, 1, 3600);
    EXPECT_NEAR(wall.film(), 2, threeSigma(2, rain.dropMass));
}

TEST(Rain, WithoutGravityItsIntensityIsAcrossTheFall) {
    Cloth cloth(1, 20);
    cloth.up.setZero();
    cloth.move([](const Vector3d& p) { return Vector3d(0, p.x(), p.z()); });
    Rain rain(1);
    rain.velocity = {6.5, 0, 0};
    run(rain, cloth, 1, 3600);
    EXPECT_NEAR(cloth.film(), 1, threeSigma(1, rain.dropMass));
}

TEST(Rain, IsKeptOffByARoofOverHalfTheSheet) {
    Cloth cloth(1, 20);
    cloth.shelter.blocks = roof(3, 0.51);
    Rain rain(1);
    run(rain, cloth, 1, 3600);
    double open = 0;
    for (std::size_t node = 0; node < cloth.mesh.size(); ++node) {
        EXPECT_EQ(cloth.filmMass[node] > 0, cloth.positions[node].x() < 0.51) << node;
        if (cloth.positions[node].x() < 0.51) open += cloth.mesh.areas[node];
    }
    EXPECT_NEAR(cloth.film(), open, threeSigma(open, rain.dropMass));
    // One ray for each drop that would have landed, in the open or not.
    EXPECT_NEAR(cloth.shelter.asked * rain.dropMass, 1, threeSigma(1, rain.dropMass));
    // The same roof is too high to count.
    rain.shelterHeight = 2;
    Cloth under(1, 20);
    under.shelter.blocks = cloth.shelter.blocks;
    run(rain, under, 1, 3600);
    EXPECT_NEAR(under.film(), 1, threeSigma(1, rain.dropMass));
}

TEST(Rain, SlantedReachesUnderARoof) {
    // At 45 degrees the edge of a roof 0.3 m up keeps dry what lies 0.3 m further downwind.
    Cloth cloth(1, 20);
    cloth.shelter.blocks = roof(0.3, 0.51);
    Rain rain(1);
    rain.velocity = {6, -6, 0};
    run(rain, cloth, 1, 3600);
    for (std::size_t node = 0; node < cloth.mesh.size(); ++node)
        EXPECT_EQ(cloth.filmMass[node] > 0, cloth.positions[node].x() < 0.81) << node;
}

TEST(Rain, RepeatsItselfForASeed) {
    Cloth first(1, 10), second(1, 10), other(1, 10);
    Rain rain(10, 5), same(10, 5), unlike(10, 6);
    run(rain, first, 0.01, 100);
    run(same, second, 0.01, 100);
    run(unlike, other, 0.01, 100);
    EXPECT_GT(first.film(), 0);
    EXPECT_EQ(first.filmMass, second.filmMass);
    EXPECT_NE(first.filmMass, other.filmMass);
}

TEST(Rain, KeepsItsMassInFewerHeavierDrops) {
    // An hour of a cloudburst in each step: 1000 kg, of at most 500 drawn drops two in three land.
    Cloth cloth(1, 20);
    Rain rain(1000);
    constexpr int steps = 200;
    std::size_t max = 0;
    for (int step = 0; step < steps; ++step) {
        const std::size_t before = cloth.arrivals.size();
        rain.supply(cloth.pose(), 3600, cloth);
        max = std::max(max, cloth.arrivals.size() - before);
    }
    EXPECT_LE(max, 500u);
    EXPECT_GT(max, 300u);
    const double spread = 1000 * std::sqrt(0.5 / 500.0);  // of one step, binomial
    EXPECT_NEAR(cloth.film() / steps, 1000, 3 * spread / std::sqrt(steps));

    // Just over the limit on average: nothing may be lost to the cut either.
    Cloth steady(1, 20);
    Rain shower(1);
    shower.maxDrops = 100;
    run(shower, steady, 1, 3600);
    EXPECT_NEAR(steady.film(), 1, 1.1 * threeSigma(1, shower.dropMass));
}

TEST(Rain, ArrivesWithItsVelocity) {
    Cloth cloth(1, 10);
    Rain rain(100);
    rain.velocity = {2, -6, 1};
    run(rain, cloth, 0.1, 10);
    ASSERT_FALSE(cloth.arrivals.empty());
    for (const Vector3d& velocity : cloth.arrivals) EXPECT_EQ(velocity, rain.velocity);
}

TEST(Refusals, RainOutOfRange) {
    const Rain rain(10);
    expectRange(rain, &Rain::intensity, "Rain::intensity", 0, 1000);
    expectRange(rain, &Rain::shelterHeight, "Rain::shelterHeight", 0, 1000);
    expectRange(rain, &Rain::dropMass, "Rain::dropMass", 1e-8, 1e-4);
    expectCount(rain, &Rain::maxDrops, "Rain::maxDrops");
    for (const Vector3d& velocity : {Vector3d(0, 0, 0), Vector3d(0, -0.05, 0), Vector3d(0, -51, 0),
                                     Vector3d(nan, -6, 0), Vector3d(6, 0, 0), Vector3d(0, 6, 0)}) {
        Rain changed = rain;
        changed.velocity = velocity;
        expectRefusal(changed, "Rain::velocity");
    }
}

}  // namespace
}  // namespace drench::rain_test
