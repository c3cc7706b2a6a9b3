#include "drench/sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "drench/water.h"
#include "sheet_stand_in.h"

namespace drench::pool_test {
namespace {

using Eigen::Vector3d;
using test::Cloth;
using test::expectRange;
using test::expectRefusal;
using test::nan;
using test::run;

TEST(Pool, FillsThePoresAtThePaceOfTheFabric) {
    for (const double dt : {0.01, 0.5}) {
        Cloth cloth(1, 4);
        Pool pool(0.1);
        for (int step = 0; step < static_cast<int>(std::lround(3 / dt)); ++step) {
            run(pool, cloth, dt, 1);
            cloth.absorb(dt);
        }
        EXPECT_NEAR(cloth.film(), 2 * waterDensity * retainedFilmThickness, 1e-12);
        for (std::size_t node = 0; node < cloth.mesh.size(); ++node) {
            const double full = 0.3 * cloth.mesh.areas[node];
            EXPECT_NEAR(cloth.poreMass[node] / full, 1 - std::exp(-3.0 / 2), 1e-12) << dt;
            EXPECT_EQ(cloth.covered[node], 1);
        }
    }
}

TEST(Pool, DrawsTheFilmOfLandauAndLevich) {
    // At 1 m/s: 0.94 x 2.724 mm x 0.01374^(2/3) = 147 um a face.
    struct Case {
        double speed, thickness, tolerance;
    };
    for (const Case& given :
         {Case{1, 146.9e-6, 0.2e-6}, Case{-1, 146.9e-6, 0.2e-6}, Case{0.5, 92.5e-6, 0.2e-6},
          Case{0, retainedFilmThickness, 1e-15}, Case{10, thickestFilm, 1e-15}}) {
        Cloth cloth(1, 4);
        cloth.fill();
        for (Vector3d& velocity : cloth.velocities) velocity = {0, given.speed, 0};
        Pool pool(0.1);
        run(pool, cloth, 0.01, 3);
        EXPECT_NEAR(cloth.film() / (2 * waterDensity), given.thickness, given.tolerance) << given.speed;
    }
}

TEST(Pool, DrawsNoFilmThatRunsOffWithinTheStep) {
    // (0.001 Pa s x 1 m / (1000 kg/m3 x 9.81 m/s2 x dt))^1/2: 101 um after 10 s.
    for (const auto& [dt, thickness] : {std::pair{10.0, 100.7e-6}, {1000.0, retainedFilmThickness}}) {
        Cloth cloth(1, 4);
        cloth.fill();
        for (Vector3d& velocity : cloth.velocities) velocity = {0, 1, 0};
        Pool pool(0.1);
        run(pool, cloth, dt, 3);
        EXPECT_NEAR(cloth.film() / (2 * waterDensity), thickness, 0.6e-6) << dt;
    }
}

TEST(Pool, TakesBackTheSurplusOfTheFilm) {
    Cloth cloth(1, 4);
    cloth.fill();
    for (std::size_t node = 0; node < cloth.mesh.size(); ++node)
        cloth.filmMass[node] = cloth.mesh.areas[node];
    Pool pool(0.1);
    run(pool, cloth, 0.01, 2);
    EXPECT_NEAR(cloth.film(), 2 * waterDensity * retainedFilmThickness, 1e-12);
    EXPECT_NEAR(cloth.taken, 1 - cloth.film(), 1e-12);
}

// Places of the nodes that a pool wets.
std::vector<Vector3d> wetPositions(const Cloth& cloth) {
    std::vector<Vector3d> positions;
    for (std::size_t node = 0; node < cloth.mesh.size(); ++node) {
        EXPECT_EQ(cloth.filmMass[node] > 0, cloth.covered[node] > 0) << node;
        EXPECT_EQ(cloth.filmMass[node] > 0, cloth.submerged[node] > 0) << node;
        if (cloth.filmMass[node] > 0) positions.push_back(cloth.positions[node]);
    }
    return positions;
}

TEST(Pool, WetsOnlyWhatIsUnderItsLevel) {
    Cloth cloth(1, 10);
    cloth.move([](const Vector3d& p) { return Vector3d(0, p.x(), p.z()); });
    Pool pool(0.35);
    run(pool, cloth, 0.1, 1);
    EXPECT_EQ(wetPositions(cloth).size(), 4u * 11u);
    for (const Vector3d& position : wetPositions(cloth)) EXPECT_LT(position.y(), 0.35);
}

TEST(Pool, WetsOnlyInsideItsRectangleWhicheverWayIsUp) {
    // The cloth in a world with another way up: its first and second side, and up.
    const std::vector<std::array<Vector3d, 3>> worlds = {
        {Vector3d::UnitX(), Vector3d::UnitZ(), Vector3d::UnitY()},
        {Vector3d::UnitX(), Vector3d::UnitZ(), -Vector3d::UnitY()},
        {Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()},
        {Vector3d::UnitY(), Vector3d::UnitZ(), Vector3d::UnitX()},
        {Vector3d(0.8, 0.6, 0), Vector3d::UnitZ(), Vector3d(-0.6, 0.8, 0)},
        {Vector3d::UnitX(), Vector3d(0, 0.6, 0.8), Vector3d(0, 0.8, -0.6)},
    };
    for (const auto& [first, second, up] : worlds) {
        Cloth cloth(1, 10);
        const Vector3d across = first, further = second, upward = up;
        cloth.up = upward;
        cloth.move(
            [&](const Vector3d& p) -> Vector3d { return p.x() * across + p.z() * further + 2 * upward; });
        Pool pool(2.1);
        pool.from = {0.15, 0.45};
        pool.to = {0.35, 0.95};
        run(pool, cloth, 0.1, 1);
        EXPECT_EQ(wetPositions(cloth).size(), 2u * 5u) << up.transpose();
        for (const Vector3d& position : wetPositions(cloth)) {
            EXPECT_NEAR(position.dot(first), 0.25, 0.1) << up.transpose();
            EXPECT_NEAR(position.dot(second), 0.7, 0.25) << up.transpose();
        }
        Cloth above = cloth;
        std::fill(above.filmMass.begin(), above.filmMass.end(), 0);
        pool.level = 1.9;
        run(pool, above, 0.1, 1);
        EXPECT_EQ(above.film(), 0);
    }
}

// Share of a level cloth at height 0 that is under water.
double fractionAt(double level, double dt = 0.1) {
    Cloth cloth(1, 4);
    Pool pool(level);
    run(pool, cloth, dt, 1);
    for (const double fraction : cloth.submerged) EXPECT_EQ(fraction, cloth.submerged[0]);
    return cloth.submerged[0];
}

TEST(Pool, CoversANodeSmoothlyFromOneCentimetreAboveItsLevelToOneBelow) {
    EXPECT_EQ(fractionAt(-0.0101), 0);
    EXPECT_EQ(fractionAt(0.0101), 1);
    EXPECT_EQ(fractionAt(100), 1);
    EXPECT_NEAR(fractionAt(0), 0.5, 1e-12);
    EXPECT_NEAR(fractionAt(0.005), 0.84375, 1e-12);  // 3 t^2 - 2 t^3 at t = 3/4
    double before = 0;
    for (double level = -0.0099; level < 0.01; level += 1e-4) {
        const double fraction = fractionAt(level);
        EXPECT_GT(fraction, before);
        EXPECT_LT(fraction, before + 0.0076);  // steepest at the level: 1.5 / 2 cm
        before = fraction;
    }
}

// Film of a level cloth of that floating share above a level, kg/m2.
double filmAbove(double height, double floatingFraction) {
    Cloth cloth(1, 4);
    cloth.floatingFraction = floatingFraction;
    Pool pool(-height);
    run(pool, cloth, 0.5, 1);
    EXPECT_GT(cloth.submerged[0], 0);
    for (std::size_t node = 0; node < cloth.mesh.size(); ++node)
        EXPECT_EQ(cloth.covered[node], cloth.filmMass[node] > 0 ? 1 : 0);
    return cloth.film();
}

TEST(Pool, WetsAsHighAsAMeniscusAndWhatFloats) {
    const double film = 2 * waterDensity * retainedFilmThickness + 0.3 * -std::expm1(-0.25);
    const double capillaryLength = std::sqrt(waterSurfaceTension / (waterDensity * 9.81));
    EXPECT_NEAR(capillaryLength, 2.7e-3, 0.05e-3);
    for (const double height : {-0.02, 0.0, 0.9 * capillaryLength})
        EXPECT_NEAR(filmAbove(height, 0.5), film, 1e-12) << height;
    for (const double height : {1.1 * capillaryLength, 0.0099})
        EXPECT_EQ(filmAbove(height, 0.5), 0) << height;
    // Thick cloth that is mostly air floats higher: with a seventh under water at 5.4 mm.
    EXPECT_NEAR(filmAbove(0.0054, 1.0 / 7), film, 1e-12);
    EXPECT_EQ(filmAbove(0.0060, 1.0 / 7), 0);
}

TEST(Pool, CarriesClothAlsoWhileWaterTimeStandsStill) {
    EXPECT_EQ(fractionAt(0.02, 0), 1);
}

TEST(Pool, IsNotThereWithoutGravity) {
    Cloth cloth(1, 4);
    cloth.up.setZero();
    cloth.gravity = 0;
    Pool pool(0.1);
    run(pool, cloth, 1, 1);
    EXPECT_EQ(cloth.film(), 0);
    EXPECT_EQ(cloth.covered[0], 0);
    EXPECT_EQ(cloth.submerged[0], 0);
}

TEST(Refusals, PoolOutOfRange) {
    const Pool pool(0);
    expectRange(pool, &Pool::level, "Pool::level", -1e9, 1e9);
    Pool turned(0), lost(0), endless(0);
    turned.from = {1, 0};
    turned.to = {0, 1};
    lost.from.y() = nan;
    endless.to.x() = std::numeric_limits<double>::infinity();
    expectRefusal(turned, "Pool::from");
    expectRefusal(lost, "Pool::from");
    expectRefusal(endless, "Pool::to");
}

}  // namespace
}  // namespace drench::pool_test
