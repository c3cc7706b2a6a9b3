#include "drench/sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sheet_stand_in.h"

namespace drench::spray_test {
namespace {

using Eigen::Vector3d;
using test::Cloth;
using test::expectCount;
using test::expectRange;
using test::expectRefusal;
using test::nan;
using test::pi;
using test::run;

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

}  // namespace
}  // namespace drench::spray_test
