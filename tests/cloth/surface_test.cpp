#include "drench/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "drench/water.h"
#include "drench/wet_laws.h"

namespace drench::surface_test {
namespace {

TEST(Surface, FrictionRisesToItsDampPeakAndFallsAsAFilmLubricates) {
    for (const std::string& name : fabrics::names()) {
        const Fabric fabric = fabrics::byName(name);
        const Surface plate = surfaceOf(fabric, SurfaceKind::plate);
        EXPECT_DOUBLE_EQ(frictionCoefficient(plate, 0, 0), fabric.plateFrictionDry);
        EXPECT_DOUBLE_EQ(frictionCoefficient(plate, 0.6, 0), fabric.plateFrictionDamp);
        EXPECT_DOUBLE_EQ(frictionCoefficient(plate, 1, retainedFilmThickness), fabric.plateFrictionDamp);
        EXPECT_DOUBLE_EQ(frictionCoefficient(plate, 1, 1e-4), fabric.plateFrictionSoaked);
        double before = frictionCoefficient(plate, 0, 0);
        for (double s = 0.01; s <= 1; s += 0.01) {
            EXPECT_GE(frictionCoefficient(plate, s, 0), before);
            before = frictionCoefficient(plate, s, 0);
        }
        for (double film = 0; film < 3e-4; film += 5e-6) {
            EXPECT_LE(frictionCoefficient(plate, 1, film), before);
            before = frictionCoefficient(plate, 1, film);
        }
        const Surface skin = surfaceOf(fabric, SurfaceKind::skin);
        EXPECT_DOUBLE_EQ(frictionCoefficient(skin, 0.7, 0), fabric.skinFrictionDamp);
        const Surface rough = surfaceOf(fabric, SurfaceKind::rough);
        EXPECT_GE(rough.frictionDry, plate.frictionDamp);
        EXPECT_LT(rough.wettability, plate.wettability);
        EXPECT_NO_THROW(validate(rough));
    }
}

TEST(Surface, ClingComesWithWaterAndGoesWithTheFilm) {
    for (const std::string& name : fabrics::names()) {
        const Fabric fabric = fabrics::byName(name);
        const WetLaws laws(fabric);
        const double bound = fabric.boundMaximum * fabric.arealDensity / fabric.poreCapacity();
        EXPECT_EQ(laws.clingEnergy(0, 0), 0) << name;
        EXPECT_EQ(laws.clingEnergy(0.9 * bound, 0), 0) << name;
        for (const double s : {0.3, 0.6, 0.9, 1.0})
            EXPECT_DOUBLE_EQ(laws.clingEnergy(s, retainedFilmThickness), fabric.clingEnergy) << name;
        EXPECT_GT(laws.clingEnergy(1, 1.5e-4), 0) << name;
        EXPECT_EQ(laws.clingEnergy(1, 2e-4), 0) << name;
        EXPECT_EQ(laws.clingEnergy(1, thickestFilm), 0) << name;
    }
}

TEST(Surface, ValuesOutOfRangeAreNamed) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Surface& surface :
         {Surface{-0.1, 1, 1, 1}, Surface{1, 6, 1, 1}, Surface{1, 1, nan, 1}, Surface{1, 1, 1, 1.1}})
        EXPECT_THROW(validate(surface), std::invalid_argument);
    try {
        validate({1, 6, 1, 1});
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("frictionDamp is 6"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace drench::surface_test
