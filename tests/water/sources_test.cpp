#include "drench/sources.h"

#include <gtest/gtest.h>
#include <stb_image_write.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <numeric>
#include <string>

#include "drench/water.h"

namespace drench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A shelter that counts how often it is asked.
struct CountingShelter final : Shelter {
    std::function<bool(const Vector3d&, const Vector3d&)> blocks = [](auto&, auto&) { return false; };
    mutable int asked = 0;
    bool blocked(const Vector3d& from, const Vector3d& to) const override {
        ++asked;
        return blocks(from, to);
    }
};

// A flat roof at a height, endless but for x below its edge.
std::function<bool(const Vector3d&, const Vector3d&)> roof(double height, double edge) {
    return [=](const Vector3d& from, const Vector3d& to) {
        const double share = (height - from.y()) / (to.y() - from.y());
        return share > 0 && share < 1 && (from + share * (to - from)).x() > edge;
    };
}

// A square of cloth on a grid that keeps its own water and writes down what it is given.
struct Cloth final : Supply {
    ClothMesh mesh;
    std::vector<Vector3d> positions, velocities;
    std::vector<std::vector<int>> trianglesAround;
    std::vector<double> poreMass, filmMass, covered;
    std::vector<Vector3d> arrivals;  // velocities of what came with one
    double poreCapacity = 0.3, wettingTime = 2, gravity = 9.81;
    Vector3d up = {0, 1, 0};
    CountingShelter shelter;
    double taken = 0;

    // Lies level from (0, 0, 0) to (side, 0, side), u along x and v along z.
    Cloth(double side, int cells) {
        const int row = cells + 1;
        std::vector<Vector2d> flat;
        for (int i = 0; i < row * row; ++i) {
            flat.push_back(side / cells * Vector2d(i % row, i / row));
            positions.emplace_back(flat.back().x(), 0, flat.back().y());
        }
        const auto size = positions.size();
        mesh.areas.assign(size, 0);
        trianglesAround.resize(size);
        for (std::vector<double>* mass : {&poreMass, &filmMass, &covered}) mass->assign(size, 0);
        velocities.assign(size, Vector3d::Zero());
        for (int i = 0; i < cells * cells; ++i) {
            const int corner = i / cells * row + i % cells;
            addTriangle({corner, corner + row, corner + 1}, flat);
            addTriangle({corner + 1, corner + row, corner + row + 1}, flat);
        }
    }

    void addTriangle(const std::array<int, 3>& corners, const std::vector<Vector2d>& flat) {
        std::array<Vector2d, 3> at;
        for (std::size_t i = 0; i < 3; ++i) at[i] = flat[static_cast<std::size_t>(corners[i])];
        const Vector2d one = at[1] - at[0], other = at[2] - at[0];
        for (const int node : corners) {
            mesh.areas[static_cast<std::size_t>(node)] +=
                std::abs(one.x() * other.y() - one.y() * other.x()) / 6;
            trianglesAround[static_cast<std::size_t>(node)].push_back(
                static_cast<int>(mesh.triangles.size()));
        }
        mesh.triangles.push_back(corners);
        mesh.coordinates.push_back(at);
    }

    SheetPose pose() const {
        return {mesh,
                positions,
                velocities,
                trianglesAround,
                poreMass,
                filmMass,
                poreCapacity,
                wettingTime,
                up,
                gravity,
                std::accumulate(mesh.areas.begin(), mesh.areas.end(), 0.0),
                shelter,
                nullptr};
    }
    void move(const std::function<Vector3d(const Vector3d&)>& to) {
        for (Vector3d& place : positions) place = to(place);
    }
    double film() const { return std::accumulate(filmMass.begin(), filmMass.end(), 0.0); }

    void check(std::size_t node, double mass) const {
        ASSERT_LT(node, mesh.size());
        EXPECT_GT(mesh.areas[node], 0);
        EXPECT_TRUE(std::isfinite(mass) && mass >= 0) << mass;
    }
    void addFilm(std::size_t node, double mass, const Vector3d& velocity) override {
        arrivals.push_back(velocity);
        addFilm(node, mass);
    }
    void addFilm(std::size_t node, double mass) override {
        check(node, mass);
        filmMass[node] += mass;
    }
    void addPores(std::size_t node, double mass) override {
        check(node, mass);
        poreMass[node] += mass;
    }
    double takeFilm(std::size_t node, double mass) override {
        check(node, mass);
        filmMass[node] -= mass;
        taken += mass;
        return mass;
    }
    double takePores(std::size_t, double) override { return 0; }
    void cover(std::size_t node, double share) override { covered[node] = share; }
};

// Steps a source on a cloth.
void run(Source& source, Cloth& cloth, double dt, int steps) {
    for (int step = 0; step < steps; ++step) source.supply(cloth.pose(), dt, cloth);
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

// ---- Rain

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
    std::size_t most = 0;
    for (int step = 0; step < steps; ++step) {
        const std::size_t before = cloth.arrivals.size();
        rain.supply(cloth.pose(), 3600, cloth);
        most = std::max(most, cloth.arrivals.size() - before);
    }
    EXPECT_LE(most, 500u);
    EXPECT_GT(most, 300u);
    const double spread = 1000 * std::sqrt(0.5 / 500.0);  // of one step, binomial
    EXPECT_NEAR(cloth.film() / steps, 1000, 3 * spread / std::sqrt(steps));

    // Just over the limit on average: nothing may be lost to the cut either.
    Cloth steady(1, 20);
    Rain shower(1);
    shower.mostDrops = 100;
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

// ---- Spray

// A sheet in the middle under a nozzle.
Cloth under(double distance, double side, int cells) {
    Cloth cloth(side, cells);
    cloth.move([&](const Vector3d& p) { return Vector3d(p.x() - side / 2, -distance, p.z() - side / 2); });
    return cloth;
}

TEST(Spray, ASheetAcrossTheWholeConeCatchesAll) {
    for (const double halfAngle : {0.1, 0.3, 0.8}) {
        const double radius = std::tan(halfAngle);
        Cloth cloth = under(1, 3.01 * radius, 120);
        Spray spray({0, 0, 0}, {0, -3, 0}, 0.2);
        spray.halfAngle = halfAngle;
        run(spray, cloth, 0.01, 100);
        EXPECT_NEAR(cloth.film(), 0.2, 0.03 * 0.2) << halfAngle;
        for (std::size_t node = 0; node < cloth.mesh.size(); ++node) {
            const bool inside = std::hypot(cloth.positions[node].x(), cloth.positions[node].z()) < radius;
            EXPECT_EQ(cloth.filmMass[node] > 0, inside) << node;
        }
    }
}

TEST(Spray, ASheetAcrossHalfTheConeCatchesHalf) {
    Cloth cloth = under(1, 1, 120);
    cloth.move([](const Vector3d& p) { return Vector3d(p.x() + 0.5, p.y(), p.z()); });
    Spray spray({0, 0, 0}, {0, -1, 0}, 0.2);
    spray.halfAngle = 0.4;
    run(spray, cloth, 0.01, 100);
    EXPECT_NEAR(cloth.film(), 0.1, 0.03 * 0.1);
}

TEST(Spray, FallsWithTheSquareOfTheDistance) {
    Cloth near = under(2, 0.02, 4), far = under(6, 0.02, 4);
    Spray spray({0, 0, 0}, {0, -1, 0}, 1);
    run(spray, near, 1, 1);
    run(spray, far, 1, 1);
    EXPECT_NEAR(near.film() / far.film(), 9, 0.01);
    const double cone = 2 * pi * (1 - std::cos(0.2));
    EXPECT_NEAR(far.film(), 0.02 * 0.02 / 36 / cone, 1e-4 * far.film());
}

TEST(Spray, ArrivesFromTheNozzle) {
    Cloth cloth = under(1, 0.4, 10);
    Spray spray({0, 0, 0}, {0, -1, 0}, 1);
    run(spray, cloth, 1, 1);
    Vector3d mean = Vector3d::Zero();
    for (const Vector3d& velocity : cloth.arrivals) {
        EXPECT_NEAR(velocity.norm(), 5, 1e-12);
        EXPECT_LE(velocity.y(), -5 * std::cos(0.2));
        mean += velocity;
    }
    EXPECT_NEAR(mean.x() / mean.y(), 0, 1e-12);
    const auto aside = [](const Vector3d& v) { return std::abs(v.x()) > 0.5; };
    EXPECT_TRUE(std::any_of(cloth.arrivals.begin(), cloth.arrivals.end(), aside));
}

TEST(Spray, NeverGivesMoreThanItsRate) {
    // At the nozzle itself a node fills the whole view, and a fold behind another asks for its share again.
    for (const double distance : {0.0, 1e-5, 1e-3, 0.02}) {
        Cloth cloth = under(distance, 0.2, 4);
        Spray spray({0, 0, 0}, {0, -1, 0}, 1);
        run(spray, cloth, 1, 1);
        EXPECT_LE(cloth.film(), 1 + 1e-12) << distance;
        EXPECT_GT(cloth.film(), 0.9) << distance;
    }
}

TEST(Spray, LearnsWhatIsShelteredWithFewRays) {
    Cloth cloth = under(1, 0.28, 40);
    cloth.shelter.blocks = [](const Vector3d&, const Vector3d& to) { return to.x() > 0.001; };
    Spray spray({0, 0, 0}, {0, -1, 0}, 1);
    spray.raysPerStep = 50;
    const int steps = static_cast<int>(cloth.mesh.size()) / 50 + 1;
    for (int step = 0; step < steps; ++step) {
        const int before = cloth.shelter.asked;
        run(spray, cloth, 0.01, 1);
        EXPECT_LE(cloth.shelter.asked - before, 50);
    }
    std::fill(cloth.filmMass.begin(), cloth.filmMass.end(), 0);
    run(spray, cloth, 0.01, 5);
    for (std::size_t node = 0; node < cloth.mesh.size(); ++node)
        EXPECT_EQ(cloth.filmMass[node] > 0, cloth.positions[node].x() < 0.001) << node;
    // Once the thing is gone, so is its shelter.
    cloth.shelter.blocks = [](auto&, auto&) { return false; };
    run(spray, cloth, 0.01, steps);
    for (const double film : cloth.filmMass) EXPECT_GT(film, 0);
}

TEST(Spray, AsksNoMoreRaysThanNodesAndNoneForThoseOutside) {
    Cloth cloth = under(1, 2, 10);  // nodes 0.2 m apart: five in the cone
    Spray spray({0, 0, 0}, {0, -1, 0}, 1);
    spray.halfAngle = 0.21;
    run(spray, cloth, 0.01, 1);
    EXPECT_EQ(cloth.shelter.asked, 5);
    EXPECT_EQ(cloth.arrivals.size(), 5u);
}

// ---- Pool

TEST(Pool, FillsThePoresAtThePaceOfTheFabric) {
    for (const double dt : {0.01, 0.5}) {
        Cloth cloth(1, 4);
        Pool pool(0.1);
        run(pool, cloth, dt, static_cast<int>(std::lround(3 / dt)));
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
        for (Vector3d& velocity : cloth.velocities) velocity = {0, given.speed, 0};
        Pool pool(0.1);
        run(pool, cloth, 0.01, 3);
        EXPECT_NEAR(cloth.film() / (2 * waterDensity), given.thickness, given.tolerance) << given.speed;
    }
}

TEST(Pool, TakesBackTheSurplusOfTheFilm) {
    Cloth cloth(1, 4);
    for (std::size_t node = 0; node < cloth.mesh.size(); ++node)
        cloth.filmMass[node] = cloth.mesh.areas[node];
    Pool pool(0.1);
    run(pool, cloth, 0.01, 2);
    EXPECT_NEAR(cloth.film(), 2 * waterDensity * retainedFilmThickness, 1e-12);
    EXPECT_NEAR(cloth.taken, 1 - cloth.film(), 1e-12);
}

// Places of the nodes that a pool wets.
std::vector<Vector3d> wetPlaces(const Cloth& cloth) {
    std::vector<Vector3d> places;
    for (std::size_t node = 0; node < cloth.mesh.size(); ++node) {
        EXPECT_EQ(cloth.poreMass[node] > 0, cloth.covered[node] > 0) << node;
        EXPECT_EQ(cloth.poreMass[node] > 0, cloth.filmMass[node] > 0) << node;
        if (cloth.poreMass[node] > 0) places.push_back(cloth.positions[node]);
    }
    return places;
}

TEST(Pool, WetsOnlyWhatIsUnderItsLevel) {
    Cloth cloth(1, 10);
    cloth.move([](const Vector3d& p) { return Vector3d(0, p.x(), p.z()); });
    Pool pool(0.35);
    run(pool, cloth, 0.1, 1);
    EXPECT_EQ(wetPlaces(cloth).size(), 4u * 11u);
    for (const Vector3d& place : wetPlaces(cloth)) EXPECT_LT(place.y(), 0.35);
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
        const Vector3d across = first, further = second, way = up;
        cloth.up = way;
        cloth.move([&](const Vector3d& p) -> Vector3d { return p.x() * across + p.z() * further + 2 * way; });
        Pool pool(2.1);
        pool.from = {0.15, 0.45};
        pool.to = {0.35, 0.95};
        run(pool, cloth, 0.1, 1);
        EXPECT_EQ(wetPlaces(cloth).size(), 2u * 5u) << up.transpose();
        for (const Vector3d& place : wetPlaces(cloth)) {
            EXPECT_NEAR(place.dot(first), 0.25, 0.1) << up.transpose();
            EXPECT_NEAR(place.dot(second), 0.7, 0.25) << up.transpose();
        }
        Cloth above = cloth;
        std::fill(above.filmMass.begin(), above.filmMass.end(), 0);
        pool.level = 1.9;
        run(pool, above, 0.1, 1);
        EXPECT_EQ(above.film(), 0);
    }
}

TEST(Pool, IsNotThereWithoutGravity) {
    Cloth cloth(1, 4);
    cloth.up.setZero();
    cloth.gravity = 0;
    Pool pool(0.1);
    run(pool, cloth, 1, 1);
    EXPECT_EQ(cloth.film(), 0);
    EXPECT_EQ(cloth.covered[0], 0);
}

// ---- Soak

TEST(Soak, GivesExactlyItsMassWhateverTheSteps) {
    for (const double dt : {0.001, 0.1, 0.7, 3.0, 100.0}) {
        Cloth cloth(1, 4);
        Soak soak({3, 0, 7, 3}, 0.123, 3);
        for (int step = 0; step < 5000; ++step) soak.supply(cloth.pose(), dt * (1 + step % 3), cloth);
        EXPECT_TRUE(soak.finished());
        EXPECT_NEAR(cloth.film(), 0.123, 1e-12) << dt;
        const double chosen = cloth.mesh.areas[0] + cloth.mesh.areas[3] + cloth.mesh.areas[7];
        for (const std::size_t node : {0u, 3u, 7u})
            EXPECT_NEAR(cloth.filmMass[node], 0.123 * cloth.mesh.areas[node] / chosen, 1e-12) << node;
        EXPECT_EQ(cloth.filmMass[1], 0);
    }
}

TEST(Soak, TakesItsTime) {
    Cloth cloth(1, 4);
    Soak soak({5}, 2, 10);
    run(soak, cloth, 0.1, 25);
    EXPECT_NEAR(cloth.film(), 0.5, 1e-12);
    EXPECT_FALSE(soak.finished());
    run(soak, cloth, 0.1, 75);
    EXPECT_TRUE(soak.finished());

    Soak atOnce({5}, 2);
    EXPECT_FALSE(atOnce.finished());
    run(atOnce, cloth, 1e-3, 1);
    EXPECT_TRUE(atOnce.finished());
    EXPECT_NEAR(cloth.film(), 4, 1e-12);
}

TEST(Soak, PassesByNodesWithoutClothAndRefusesToFindNone) {
    Cloth cloth(1, 4);
    cloth.mesh.areas[2] = 0;
    Soak some({1, 2}, 1), none({2}, 1), missing({25}, 1);
    run(some, cloth, 1, 1);
    EXPECT_NEAR(cloth.filmMass[1], 1, 1e-15);
    EXPECT_THROW(none.supply(cloth.pose(), 0, cloth), std::invalid_argument);
    EXPECT_THROW(missing.supply(cloth.pose(), 0, cloth), std::out_of_range);
    EXPECT_NEAR(cloth.film(), 1, 1e-15);
}

// A file that goes when the test does.
struct TemporaryFile {
    std::filesystem::path path;
    explicit TemporaryFile(const std::string& name)
        : path(std::filesystem::path(testing::TempDir()) / name) {}
    ~TemporaryFile() {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
    }
};

// Writes a PNG of colours as (red, green, blue, alpha).
void writePicture(const TemporaryFile& file, int width,
                  const std::vector<std::array<unsigned char, 4>>& pixels) {
    const int height = static_cast<int>(pixels.size()) / width;
    ASSERT_NE(stbi_write_png(file.path.string().c_str(), width, height, 4, pixels.data(), 4 * width), 0);
}

TEST(Soak, LaysAPictureOverTheSheet) {
    TemporaryFile file("drench_sources_test_halves.png");
    // 100 x 2: the left half white; only its lower row is seen at v below a half.
    std::vector<std::array<unsigned char, 4>> pixels(200, {0, 0, 0, 255});
    for (std::size_t i = 0; i < 50; ++i) pixels[i] = pixels[100 + i] = {255, 255, 255, 255};
    writePicture(file, 100, pixels);

    Cloth cloth(1, 10);  // a column of nodes stands right on the border, where the picture is half grey
    Soak soak = Soak::picture(readMask(file.path), 0.4, 2);
    run(soak, cloth, 0.5, 4);
    EXPECT_TRUE(soak.finished());
    EXPECT_NEAR(cloth.film(), 0.4 * 0.5, 1e-12);
    for (std::size_t node = 0; node < cloth.mesh.size(); ++node) {
        const double x = cloth.positions[node].x();
        const double white = x < 0.49 ? 1 : x > 0.51 ? 0 : 0.5;
        EXPECT_NEAR(cloth.filmMass[node], 0.4 * white * cloth.mesh.areas[node], 1e-12) << node;
    }
}

TEST(Soak, LaysThePictureUpright) {
    // Four pixels: white at the lower right, that is at great u and small v.
    const Mask mask{2, 2, {0, 0, 0, 1}};
    Cloth cloth(1, 1);
    for (auto& corners : cloth.mesh.coordinates)
        for (Vector2d& corner : corners) corner += Vector2d(7, -3);  // wherever the pattern lies on its paper
    Soak soak = Soak::picture(mask, 1);
    run(soak, cloth, 1, 1);
    EXPECT_EQ(cloth.filmMass[0], 0);
    EXPECT_NEAR(cloth.filmMass[1], cloth.mesh.areas[1], 1e-12);
    EXPECT_EQ(cloth.filmMass[2], 0);
    EXPECT_EQ(cloth.filmMass[3], 0);
}

TEST(Soak, ABlackPictureGivesNothing) {
    Cloth cloth(1, 2);
    Soak soak = Soak::picture(Mask{1, 1, {0}}, 1);
    run(soak, cloth, 1, 2);
    EXPECT_TRUE(soak.finished());
    EXPECT_EQ(cloth.film(), 0);
}

// ---- Mask

TEST(Mask, InterpolatesBetweenPixelsAndHoldsAtTheEdges) {
    const Mask mask{2, 2, {0, 1, 0.5, 0.25}};
    EXPECT_DOUBLE_EQ(mask.at(0.25, 0.75), 0);  // the upper left pixel's middle
    EXPECT_DOUBLE_EQ(mask.at(0.75, 0.75), 1);
    EXPECT_DOUBLE_EQ(mask.at(0.25, 0.25), 0.5);
    EXPECT_DOUBLE_EQ(mask.at(0.5, 0.75), 0.5);
    EXPECT_DOUBLE_EQ(mask.at(0.5, 0.5), 1.75 / 4);
    EXPECT_DOUBLE_EQ(mask.at(9, -9), 0.25);
    EXPECT_DOUBLE_EQ(mask.at(-std::numeric_limits<double>::infinity(), 0), 0.5);
    EXPECT_THROW(mask.at(nan, 0), std::invalid_argument);
    EXPECT_THROW(Mask().at(0, 0), std::invalid_argument);
    EXPECT_THROW((Mask{2, 2, {0}}.at(0, 0)), std::invalid_argument);
}

TEST(Mask, ReadsGreysColoursAndTransparency) {
    TemporaryFile file("drench_sources_test_colours.png");
    writePicture(file, 3,
                 {{255, 255, 255, 255},
                  {128, 128, 128, 255},
                  {0, 0, 0, 255},
                  {255, 255, 255, 0},
                  {255, 255, 255, 51},
                  {0, 255, 0, 255}});
    const Mask mask = readMask(file.path);
    ASSERT_EQ(mask.width, 3);
    ASSERT_EQ(mask.height, 2);
    const std::vector<double> expected = {1, 128 / 255.0, 0, 0, 0.2, 0.7152};
    ASSERT_EQ(mask.values.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(mask.values[i], expected[i], 1e-6) << i;
}

// What a function complains of.
std::string complaint(const std::function<void()>& act) {
    try {
        act();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "nothing";
}

TEST(Mask, SaysWhichFileItCannotReadAndWhy) {
    TemporaryFile broken("drench_sources_test_broken.png"), empty("drench_sources_test_empty.png");
    std::ofstream(broken.path) << "this is no picture";
    std::ofstream(empty.path).flush();
    const std::vector<std::pair<std::filesystem::path, std::string>> cases = {
        {"/no/such/mask.png", "no such file"},
        {broken.path, "it is no picture"},
        {empty.path, "it is empty"},
        {testing::TempDir(), "folder"},
    };
    for (const auto& [path, why] : cases) {
        const std::filesystem::path file = path;
        EXPECT_THROW(readMask(file), std::runtime_error);
        const std::string said = complaint([&] { readMask(file); });
        EXPECT_EQ(said.rfind("drench: ", 0), 0u) << said;
        EXPECT_NE(said.find(file.string()), std::string::npos) << said;
        EXPECT_NE(said.find(why), std::string::npos) << said;
    }
}

// ---- Brush

TEST(Brush, WetsMostInTheMiddleAndNothingBeyondItsRadius) {
    Cloth cloth(1, 100);
    Brush brush({0.5, 0, 0.5}, 0.3, 0.2);
    run(brush, cloth, 0.5, 4);
    for (std::size_t node = 0; node < cloth.mesh.size(); ++node) {
        const double distance = (cloth.positions[node] - brush.centre).norm() / 0.3;
        const double expected = 0.2 * 2 * std::max(1 - distance * distance, 0.0);
        EXPECT_NEAR(cloth.filmMass[node] / cloth.mesh.areas[node], expected, 1e-12) << node;
    }
    EXPECT_NEAR(cloth.film(), 0.2 * 2 * pi * 0.3 * 0.3 / 2, 1e-4);  // the integral over the disc
    // It wets a ball of space: lifted off by half its radius it reaches less.
    Cloth below(1, 100);
    brush.centre.y() = 0.15;
    run(brush, below, 2, 1);
    EXPECT_NEAR(below.film() / cloth.film(), 0.75 * 0.75, 1e-3);
}

TEST(Sources, LeaveNodesWithoutClothAlone) {
    Cloth cloth(1, 2);
    cloth.mesh.areas[4] = 0;  // the one in the middle, as if its triangles had no cloth either
    cloth.trianglesAround[4].clear();
    Rain rain(1000);
    Spray spray({0.5, 1, 0.5}, {0, -1, 0}, 1);
    spray.halfAngle = 1;
    Pool pool(0.1);
    Soak soak({0, 4}, 1), picture = Soak::picture(Mask{1, 1, {1}}, 1);
    Brush brush({0.5, 0, 0.5}, 0.6, 1);
    for (Source* source : std::vector<Source*>{&rain, &spray, &pool, &soak, &picture, &brush}) {
        const double before = cloth.film();
        run(*source, cloth, 1, 10);
        EXPECT_GT(std::abs(cloth.film() - before), 0) << source->name();
        EXPECT_EQ(cloth.filmMass[4] + cloth.poreMass[4] + cloth.covered[4], 0) << source->name();
    }
}

// ---- What they refuse

// Whether a source refuses to be on a sheet, in words that name the setting; and gives nothing then.
void expectRefusal(Source& source, const std::string& named) {
    Cloth cloth(1, 2);
    for (const double dt : {0.0, 1.0}) {
        EXPECT_THROW(source.supply(cloth.pose(), dt, cloth), std::invalid_argument) << named;
        const std::string said = complaint([&] { source.supply(cloth.pose(), dt, cloth); });
        EXPECT_EQ(said.rfind("drench: ", 0), 0u) << said;
        EXPECT_NE(said.find(named), std::string::npos) << said;
        EXPECT_TRUE(said.find("give") != std::string::npos || said.find("exchange") != std::string::npos)
            << said;
    }
    EXPECT_EQ(cloth.film(), 0);
}

template <class Kind>
void expectRange(const Kind& good, double Kind::*setting, const std::string& name, double least,
                 double most) {
    for (const double value : {std::nextafter(least, -1e300), std::nextafter(most, 1e300), nan}) {
        Kind source = good;
        source.*setting = value;
        expectRefusal(source, name);
    }
    for (const double value : {least, most}) {
        Kind source = good;
        source.*setting = value;
        Cloth cloth(1, 2);
        EXPECT_NO_THROW(source.supply(cloth.pose(), 0.01, cloth)) << name << " " << value;
    }
}

template <class Kind>
void expectCount(const Kind& good, int Kind::*setting, const std::string& name) {
    for (const int value : {0, -5, 1000001}) {
        Kind source = good;
        source.*setting = value;
        expectRefusal(source, name);
    }
}

TEST(Refusals, RainOutOfRange) {
    const Rain rain(10);
    expectRange(rain, &Rain::intensity, "Rain::intensity", 0, 1000);
    expectRange(rain, &Rain::shelterHeight, "Rain::shelterHeight", 0, 1000);
    expectRange(rain, &Rain::dropMass, "Rain::dropMass", 1e-8, 1e-4);
    expectCount(rain, &Rain::mostDrops, "Rain::mostDrops");
    for (const Vector3d& velocity : {Vector3d(0, 0, 0), Vector3d(0, -0.05, 0), Vector3d(0, -51, 0),
                                     Vector3d(nan, -6, 0), Vector3d(6, 0, 0), Vector3d(0, 6, 0)}) {
        Rain changed = rain;
        changed.velocity = velocity;
        expectRefusal(changed, "Rain::velocity");
    }
}

TEST(Refusals, SprayOutOfRange) {
    const Spray spray({0, 1, 0}, {0, -1, 0}, 1);
    expectRange(spray, &Spray::halfAngle, "Spray::halfAngle", 0.01, 1.5);
    expectRange(spray, &Spray::rate, "Spray::rate", 0, 1000);
    expectRange(spray, &Spray::speed, "Spray::speed", 0, 100);
    expectCount(spray, &Spray::raysPerStep, "Spray::raysPerStep");
    Spray aimless({0, 1, 0}, {0, 0, 0}, 1), lost({nan, 1, 0}, {0, -1, 0}, 1),
        turned({0, 1, 0}, {0, nan, 0}, 1);
    expectRefusal(aimless, "Spray::direction");
    expectRefusal(lost, "Spray::origin");
    expectRefusal(turned, "Spray::direction");
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

TEST(Refusals, BrushOutOfRange) {
    const Brush brush({0, 0, 0}, 0.1, 1);
    expectRange(brush, &Brush::radius, "Brush::radius", 1e-4, 100);
    expectRange(brush, &Brush::rate, "Brush::rate", 0, 1000);
    Brush lost({0, nan, 0}, 0.1, 1);
    expectRefusal(lost, "Brush::centre");
}

TEST(Refusals, SoakOutOfRange) {
    const Mask white{1, 1, {1}};
    for (const double bad : {-1e-9, 1.1e9, nan}) {
        EXPECT_THROW(Soak({0}, bad), std::invalid_argument) << bad;
        EXPECT_THROW(Soak({0}, 1, bad), std::invalid_argument) << bad;
        EXPECT_THROW(Soak::picture(white, bad), std::invalid_argument) << bad;
        EXPECT_THROW(Soak::picture(white, 1, bad), std::invalid_argument) << bad;
    }
    EXPECT_THROW(Soak({0}, 1.01e6), std::invalid_argument);
    EXPECT_THROW(Soak({}, 1), std::invalid_argument);
    EXPECT_THROW(Soak::picture(white, 1001), std::invalid_argument);
    EXPECT_THROW(Soak::picture(Mask(), 1), std::invalid_argument);
    EXPECT_THROW(Soak::picture(Mask{1, 1, {1.5F}}, 1), std::invalid_argument);
    EXPECT_THROW(Soak::picture(Mask{1, 1, {std::nanf("")}}, 1), std::invalid_argument);
}

TEST(Refusals, NoSourceTakesATimeThatIsNone) {
    Rain rain(1);
    Spray spray({0, 1, 0}, {0, -1, 0}, 1);
    Pool pool(1);
    Soak soak({0}, 1);
    Brush brush({0, 0, 0}, 1, 1);
    for (Source* source : std::vector<Source*>{&rain, &spray, &pool, &soak, &brush}) {
        Cloth cloth(1, 2);
        for (const double dt : {-0.1, nan, std::numeric_limits<double>::infinity()})
            EXPECT_THROW(source->supply(cloth.pose(), dt, cloth), std::invalid_argument) << source->name();
        source->supply(cloth.pose(), 0, cloth);
        EXPECT_EQ(cloth.film(), 0) << source->name();
        source->supply(cloth.pose(), 10, cloth);
        EXPECT_GT(cloth.film(), 0) << source->name();
    }
}

}  // namespace
}  // namespace drench
