#include "drench/sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

#include "sheet_stand_in.h"

namespace drench::brush_test {
namespace {

using test::Cloth;
using test::expectRange;
using test::expectRefusal;
using test::nan;
using test::pi;
using test::run;

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

TEST(Refusals, BrushOutOfRange) {
    const Brush brush({0, 0, 0}, 0.1, 1);
    expectRange(brush, &Brush::radius, "Brush::radius", 1e-4, 100);
    expectRange(brush, &Brush::rate, "Brush::rate", 0, 1000);
    Brush lost({0, nan, 0}, 0.1, 1);
    expectRefusal(lost, "Brush::centre");
}

// ---- All of them

TEST(Sources, LeaveNodesWithoutClothAlone) {
    Cloth cloth(1, 2);
    cloth.mesh.areas[4] = 0;  // the one in the middle, as if its triangles had no cloth either
    cloth.trianglesAround[4].clear();
    Rain rain(1000);
    Spray spray({0.5, 1, 0.5}, {0, -1, 0}, 1);
    spray.halfAngle = 1;
    Pool pool(0.1);
    TimedSoak soak({0, 4}, 1), picture = TimedSoak::picture(Mask{1, 1, {1}}, 1);
    Brush brush({0.5, 0, 0.5}, 0.6, 1);
    for (Source* source : std::vector<Source*>{&rain, &spray, &pool, &soak, &picture, &brush}) {
        const double before = cloth.film();
        run(*source, cloth, 1, 10);
        EXPECT_GT(std::abs(cloth.film() - before), 0) << source->name();
        EXPECT_EQ(cloth.filmMass[4] + cloth.poreMass[4] + cloth.covered[4], 0) << source->name();
    }
}

TEST(Refusals, NoSourceTakesATimeThatIsNone) {
    Rain rain(1);
    Spray spray({0, 1, 0}, {0, -1, 0}, 1);
    Pool pool(1);
    TimedSoak soak({0}, 1);
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
}  // namespace drench::brush_test
