#include "drench/wet_laws.h"

#include <gtest/gtest.h>

#include <cmath>

namespace drench::wet_laws_test {
namespace {

TEST(WetLaws, StiffnessFallsLinearlyToTheWetRatioAtTheBoundMaximum) {
    const WetLaws laws(fabrics::cottonPlain());
    EXPECT_DOUBLE_EQ(laws.stretchRatio(0), 1.0);
    EXPECT_NEAR(laws.stretchRatio(0.11), 0.8, 1e-12);
    EXPECT_NEAR(laws.stretchRatio(0.22), 0.6, 1e-12);
    EXPECT_NEAR(laws.stretchRatio(1.5), 0.6, 1e-12);
    EXPECT_NEAR(laws.bendingRatio(0.22), 0.6, 1e-12);
    EXPECT_NEAR(laws.bendingFrictionRatio(0.22), 1.7, 1e-12);
    // No jerk: a hundredth more water never changes it by more than its slope allows.
    for (double moistureContent = 0; moistureContent < 0.5; moistureContent += 0.001)
        EXPECT_LE(std::abs(laws.stretchRatio(moistureContent + 0.001) - laws.stretchRatio(moistureContent)),
                  0.4 / 0.22 * 0.001 + 1e-12);
}

TEST(WetLaws, MassIsClothPlusWater) {
    const WetLaws laws(fabrics::cottonPlain());
    EXPECT_DOUBLE_EQ(laws.mass(0.02, 0.005), 0.02 * 0.150 + 0.005);
}

TEST(WetLaws, WetColourFollowsAngstrom) {
    // Angstrom (1925): a dry reflectance of 0.4 becomes 0.27.
    Fabric fabric = fabrics::cottonPlain();
    fabric.albedoRed = fabric.albedoGreen = fabric.albedoBlue = 0.4;
    const WetLaws laws(fabric);
    EXPECT_NEAR(laws.albedo(0)[0], 0.4, 1e-12);
    EXPECT_NEAR(laws.albedo(1)[0], 0.27, 0.005);
}

TEST(WetLaws, ColourDarkensAllTheWayAndMostlyBelowSixtyPercent) {
    for (const std::string& name : fabrics::names()) {
        const WetLaws laws(fabrics::byName(name));
        for (std::size_t channel = 0; channel < 3; ++channel) {
            for (int percent = 0; percent < 100; ++percent)
                EXPECT_LT(laws.albedo(0.01 * (percent + 1))[channel], laws.albedo(0.01 * percent)[channel])
                    << name;
            const double dry = laws.albedo(0)[channel], knee = laws.albedo(0.6)[channel],
                         wet = laws.albedo(1)[channel];
            EXPECT_GT((dry - knee) / (dry - wet), 0.85) << name;
        }
    }
}

TEST(WetLaws, DarkeningIsLinearInAbsorptionOverScatteringUpToSixtyPercent) {
    const WetLaws laws(fabrics::linen());
    const auto ratio = [&](double saturation) {
        const double a = laws.albedo(saturation)[1];
        return (1 - a) * (1 - a) / (2 * a);
    };
    const double slope = (ratio(0.6) - ratio(0)) / 0.6;
    for (double s = 0; s <= 0.6; s += 0.05) EXPECT_NEAR(ratio(s), ratio(0) + slope * s, 1e-9);
}

TEST(WetLaws, TransmittanceIsThatOfAThinLayer) {
    const WetLaws laws(fabrics::cottonPlain());
    // 1 / (1 + 6) and 1 / (1 + 6/8), by hand.
    EXPECT_NEAR(laws.transmittance(0), 1.0 / 7, 1e-12);
    EXPECT_NEAR(laws.transmittance(1), 4.0 / 7, 1e-12);
    // Nine tenths of the way from 1/6 to 8/6 in 1 / (S h): 7.3/6.
    EXPECT_NEAR(laws.transmittance(0.6), 7.3 / 13.3, 1e-12);
    // Out of range is as at the ends.
    EXPECT_DOUBLE_EQ(laws.transmittance(-1), laws.transmittance(0));
    EXPECT_DOUBLE_EQ(laws.transmittance(2), laws.transmittance(1));
}

TEST(WetLaws, WetterLetsMoreLightThrough) {
    for (const std::string& name : fabrics::names()) {
        const WetLaws laws(fabrics::byName(name));
        for (int percent = 0; percent < 100; ++percent)
            EXPECT_GT(laws.transmittance(0.01 * (percent + 1)), laws.transmittance(0.01 * percent)) << name;
        EXPECT_GT(laws.transmittance(0), 0) << name;
        EXPECT_LT(laws.transmittance(1), 1) << name;
    }
}

TEST(WetLaws, ThickClothLetsLessLightThroughThanThin) {
    const WetLaws silk(fabrics::silk()), cotton(fabrics::cottonPlain()), denim(fabrics::denim());
    for (const double saturation : {0.0, 0.5, 1.0}) {
        EXPECT_GT(silk.transmittance(saturation), cotton.transmittance(saturation));
        EXPECT_GT(cotton.transmittance(saturation), denim.transmittance(saturation));
    }
}

TEST(WetLaws, WaterClosesThePoresToAir) {
    const WetLaws laws(fabrics::cottonPlain());
    EXPECT_NEAR(laws.drag(0).permeability * 100, 0.100, 1e-12);  // m/s at 100 Pa
    EXPECT_NEAR(laws.drag(1).permeability * 100, 0.005, 1e-12);
    EXPECT_NEAR(laws.drag(0.5).permeability * 100, 0.0525, 1e-12);
}

TEST(WetLaws, AFilmShinesOnceTheFacesHoldAllTheyRetain) {
    EXPECT_DOUBLE_EQ(WetLaws::gloss(0), 0.0);
    EXPECT_DOUBLE_EQ(WetLaws::gloss(9e-6), 0.5);
    EXPECT_DOUBLE_EQ(WetLaws::gloss(1e-4), 1.0);
}

TEST(WetLaws, RefusesAFabricOutOfRange) {
    Fabric fabric = fabrics::cottonPlain();
    fabric.boundMaximum = 0;
    EXPECT_THROW(WetLaws{fabric}, std::invalid_argument);
}

}  // namespace
}  // namespace drench::wet_laws_test
