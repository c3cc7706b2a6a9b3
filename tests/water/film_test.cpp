#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "cloth/meshes.h"
#include "drench/moisture.h"
#include "drench/water.h"

namespace drench::film_test {
namespace {

using meshes::LaidOut;

constexpr double gravity = 9.81;

// Cloth whose pores hold their water for good, so that only the film moves.
Fabric tightCotton() {
    Fabric fabric = fabrics::cottonPlain();
    fabric.permeabilityWarp = 1e-16;
    fabric.permeabilityWeft = 1e-16;
    return fabric;
}

// A sheet with full pores and a film of the same thickness all over.
struct Wall {
    Wall(LaidOut laid, double film) : mesh(std::move(laid)), water(tightCotton(), mesh.cloth) {
        around.gravity = gravity;
        around.heights = meshes::upright(mesh);
        for (std::size_t n = 0; n < water.size(); ++n) {
            water.addPores(n, water.poreCapacity(n));
            water.addFilm(n, 2 * waterDensity * water.area(n) * film);
        }
    }
    void run(double seconds, double dt) {
        const int steps = static_cast<int>(std::lround(seconds / dt));
        for (int i = 0; i < steps; ++i) {
            water.step(dt, around);
            for (const Moisture::Shed& shed : water.shed()) sheds.push_back(shed);
        }
    }
    double running(std::size_t node) const { return water.filmThickness(node) - retainedFilmThickness; }

    LaidOut mesh;
    Moisture water;
    Surroundings around;
    std::vector<Moisture::Shed> sheds;
};

// Largest distance from the thickness that Jeffreys (1930) gives, sqrt(mu z / (rho g t)), away from both ends.
double worstThickness(const Wall& wall, double top, double seconds) {
    double worst = 0;
    for (std::size_t n = 0; n < wall.water.size(); ++n) {
        const double depth = top - wall.mesh.positions[n].y();
        if (depth < 0.06 || depth > top - 0.011) continue;
        const double jeffreys = std::sqrt(waterViscosity * depth / (waterDensity * gravity * seconds));
        worst = std::max(worst, std::abs(wall.running(n) / jeffreys - 1));
    }
    return worst;
}

TEST(Film, ThinsAsJeffreysSays) {
    for (const double dt : {0.005, 0.02, 0.1, 0.5, 1.0}) {
        Wall wall(meshes::grid(5, 61, 0.005), 0.2e-3);
        wall.run(20, dt);
        EXPECT_LT(worstThickness(wall, 0.30, 20), 0.10) << "dt " << dt;
        EXPECT_LT(std::abs(wall.water.ledger().imbalance()), 1e-9 * wall.water.ledger().supplied)
            << "dt " << dt;
        std::printf("  dt %.3f: off by %.4f\n", dt, worstThickness(wall, 0.30, 20));
    }
}

TEST(Film, ThinsAsJeffreysSaysOnABadMesh) {
    for (const double dt : {0.005, 0.5}) {
        Wall wall(meshes::irregular(17, 61, 0.005, 4), 0.2e-3);
        wall.run(20, dt);
        double ratio = 0, count = 0;
        for (std::size_t n = 0; n < wall.water.size(); ++n) {
            const double depth = 0.30 - wall.mesh.positions[n].y();
            if (depth < 0.06 || depth > 0.28) continue;
            ratio += wall.running(n) / std::sqrt(waterViscosity * depth / (waterDensity * gravity * 20));
            ++count;
        }
        EXPECT_NEAR(ratio / count, 1, 0.10) << "dt " << dt;  // single nodes differ more
        std::printf("  dt %.3f: mean ratio %.4f\n", dt, ratio / count);
    }
}

TEST(Film, WhatIsRetainedNeverRuns) {
    for (const double dt : {0.01, 60.0}) {
        Wall wall(meshes::irregular(9, 9, 0.01, 3), 0.99 * retainedFilmThickness);
        const std::vector<double> before = wall.water.filmMass();
        wall.run(10 * dt, dt);
        // Even these pores creep, a thousandth of the film in ten minutes.
        for (std::size_t n = 0; n < before.size(); ++n)
            EXPECT_NEAR(wall.water.filmMass()[n] / before[n], 1, 0.005) << "node " << n << ", dt " << dt;
        EXPECT_TRUE(wall.sheds.empty());
    }
    for (const double dt : {0.01, 60.0}) {  // nor does it after the rest has run off
        Wall wall(meshes::grid(9, 9, 0.01), 0.1e-3);
        wall.run(100 * dt, dt);
        for (std::size_t n = 0; n < wall.water.size(); ++n)
            EXPECT_GE(wall.water.filmThickness(n), 0.9999 * retainedFilmThickness) << dt;
    }
}

// A square that hangs by one corner: heights along the diagonal.
Wall hungByACorner(double film) {
    Wall wall(meshes::grid(21, 21, 0.01), film);
    for (std::size_t n = 0; n < wall.water.size(); ++n)
        wall.around.heights[n] =
            static_cast<float>((wall.mesh.positions[n].x() + wall.mesh.positions[n].y()) / std::sqrt(2.0));
    return wall;
}

TEST(Film, ASheetHungByACornerDripsFromTheLowestOnly) {
    EXPECT_GE(dropMass, 30e-6);
    EXPECT_LE(dropMass, 85e-6);
    for (const double dt : {1.0 / 60, 1.0, 60.0}) {
        Wall wall = hungByACorner(0.1e-3);
        wall.run(600, dt);
        std::int64_t drops = 0;
        for (const Moisture::Shed& shed : wall.sheds) {
            EXPECT_EQ(shed.node, 0u) << "dt " << dt;
            drops += shed.drops;
        }
        EXPECT_GT(drops, 80) << "dt " << dt;
        EXPECT_NEAR(wall.water.ledger().dripped, double(drops) * dropMass, 1e-12);
        EXPECT_LT(wall.water.filmMass()[0],
                  2 * waterDensity * wall.water.area(0) * retainedFilmThickness + dropMass);
        std::printf("  dt %.3f: %d drops of %.1f mg\n", dt, static_cast<int>(drops), 1e6 * dropMass);
    }
}

TEST(Film, WhatCanRunDownDoesNotDrip) {
    // Each node holds several drops here, but less than the thickest film; only the lowest row has nothing below it.
    Wall wall(meshes::grid(5, 5, 0.03), 0.15e-3);
    wall.run(2, 0.01);
    EXPECT_FALSE(wall.sheds.empty());
    for (const Moisture::Shed& shed : wall.sheds) EXPECT_LT(shed.node, 5u);
}

TEST(Film, ADropThatGatheredInAStepFallsInThatStep) {
    // However long the step is: no node below which nothing is keeps a drop, and none keeps more than the
    // thickest film.
    for (const double dt : {1.0, 60.0}) {
        Wall wall = hungByACorner(0.1e-3);
        for (int i = 0; i < 3; ++i) {
            wall.run(dt, dt);
            EXPECT_LT(wall.water.filmMass()[0],
                      2 * waterDensity * wall.water.area(0) * retainedFilmThickness + dropMass)
                << "step " << i << " of " << dt << " s";
        }
    }
}

TEST(Film, NothingDripsWhereItCannotFall) {
    Wall covered = hungByACorner(0.1e-3);
    for (int i = 0; i < 600; ++i) {
        covered.water.cover(0, 1);
        covered.run(1, 1);
    }
    EXPECT_TRUE(covered.sheds.empty());
    EXPECT_GT(covered.water.filmMass()[0], 20 * dropMass);

    Wall weightless = hungByACorner(1e-3);
    weightless.around.gravity = 0;
    weightless.run(100, 1);
    EXPECT_TRUE(weightless.sheds.empty());
    EXPECT_NEAR(weightless.water.filmThickness(100), 1e-3, 1e-12);

    Wall level = hungByACorner(1e-3);
    level.around.heights.clear();
    level.run(100, 1);
    EXPECT_TRUE(level.sheds.empty());
    EXPECT_NEAR(level.water.filmThickness(100), 1e-3, 1e-12);
}

TEST(Film, ALevelSheetInAWorldWithWeightDripsUnderneath) {
    // Heights given, all the same: no node has a lower neighbour, each is a place to drip from.
    Wall level = hungByACorner(1e-3);
    std::fill(level.around.heights.begin(), level.around.heights.end(), 0.3f);
    level.run(1, 0.1);
    EXPECT_FALSE(level.sheds.empty());
    for (std::size_t n = 0; n < level.water.size(); ++n)
        EXPECT_LT(level.water.filmMass()[n],
                  2 * waterDensity * level.water.area(n) * retainedFilmThickness + dropMass);
}

TEST(Film, WhatIsOverTheThickestFilmIsLetGo) {
    for (const double dt : {1e-3, 0.1, 60.0}) {
        Wall wall(meshes::grid(5, 9, 0.02), 1e-3);
        wall.run(dt, dt);
        EXPECT_FALSE(wall.sheds.empty());
        for (std::size_t n = 0; n < wall.water.size(); ++n)
            EXPECT_LT(wall.water.filmMass()[n],
                      2 * waterDensity * wall.water.area(n) * thickestFilm + dropMass)
                << "node " << n << ", dt " << dt;
        EXPECT_LT(std::abs(wall.water.ledger().imbalance()), 1e-9 * wall.water.ledger().supplied);
    }
}

TEST(Film, StepsOfAMinuteDrainTheSheet) {
    Wall minutes(meshes::grid(9, 31, 0.01), 0.2e-3), seconds(meshes::grid(9, 31, 0.01), 0.2e-3);
    minutes.run(600, 60);
    seconds.run(600, 0.1);
    EXPECT_NEAR(minutes.water.totalFilmMass() / seconds.water.totalFilmMass(), 1, 0.10);
    EXPECT_LT(std::abs(minutes.water.ledger().imbalance()), 1e-9 * minutes.water.ledger().supplied);
    std::printf("  film left: %.3f g in minutes, %.3f g in tenths of a second\n",
                1e3 * minutes.water.totalFilmMass(), 1e3 * seconds.water.totalFilmMass());
}

TEST(Film, AStretchedSheetLosesNoWaterAndOwesNone) {
    // Far more than the stretch that the bound on steps allows for.
    for (const double stretch : {1.2, 2.0, 5.0})
        for (const double dt : {1e-3, 0.01, 0.1, 1.0, 60.0}) {
            Wall wall(meshes::irregular(7, 21, 0.01, 9), 0.25e-3);
            for (float& height : wall.around.heights) height *= static_cast<float>(stretch);
            for (int i = 0; i < 50; ++i) {
                wall.run(dt, dt);
                const auto& film = wall.water.filmMass();
                ASSERT_GE(*std::min_element(film.begin(), film.end()), 0.0) << stretch << " at " << dt;
            }
            EXPECT_LT(std::abs(wall.water.ledger().imbalance()), 1e-9 * wall.water.ledger().supplied);
        }
}

}  // namespace
}  // namespace drench::film_test
