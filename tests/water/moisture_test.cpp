#include "drench/moisture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace drench {
namespace {

Moisture oneNode(double area = 0.01) {
    return Moisture(fabrics::cottonPlain(), {area});
}

TEST(Moisture, ApproachesSaturationExponentially) {
    // With more film than the pores take, the missing water falls as exp(-t / tau): the law's closed form.
    const Fabric cotton = fabrics::cottonPlain();
    for (const double dt : {0.001, 0.1, 1.0}) {
        Moisture water = oneNode();
        water.addFilm(0, 3 * water.poreCapacity(0));
        for (double t = 0; t < 4 - dt / 2; t += dt) water.step(dt);
        EXPECT_NEAR(water.saturation(0), 1 - std::exp(-4 / cotton.wettingTime), 1e-9) << "dt " << dt;
    }
}

TEST(Moisture, ADropOnScouredCottonIsGoneWithinFiveSeconds) {
    // AATCC 79 asks for less than 5 s. A 50 mg drop on a spot of 1 cm radius.
    Moisture water = oneNode(3.14e-4);
    water.addFilm(0, 50e-6);
    for (int i = 0; i < 5 * 240; ++i) water.step(1.0 / 240);
    EXPECT_EQ(water.totalFilmMass(), 0.0);
}

TEST(Moisture, WhatThePoresCannotHoldStaysInTheFilm) {
    Moisture water = oneNode();
    water.addFilm(0, 2.5 * water.poreCapacity(0));
    water.step(1e4);
    EXPECT_DOUBLE_EQ(water.saturation(0), 1.0);
    EXPECT_NEAR(water.filmMass()[0], 1.5 * water.poreCapacity(0), 1e-15);
    EXPECT_NEAR(water.filmThickness(0), water.filmMass()[0] / (2 * 1000 * 0.01), 1e-15);
}

TEST(Moisture, ContentIsWaterOverDryCloth) {
    Moisture water = oneNode(0.02);
    water.addFilm(0, 0.006);
    EXPECT_NEAR(water.content(0), 0.006 / (0.02 * 0.150), 1e-12);
    water.step(0.5);
    EXPECT_NEAR(water.content(0), 0.006 / (0.02 * 0.150), 1e-12);  // absorbed or not
}

TEST(Moisture, TheLedgerClosesOverAMillionStepsOfRandomLength) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> area(1e-6, 1e-2), amount(0, 1e-5), time(1e-4, 0.1);
    std::vector<double> areas;
    for (int n = 0; n < 10; ++n) areas.push_back(area(random));
    Moisture water(fabrics::denim(), areas);
    for (int i = 0; i < 1000000; ++i) {
        if (i % 10 == 0) water.addFilm(static_cast<std::size_t>(i / 10 % 10), amount(random));
        water.step(time(random));
    }
    const Ledger ledger = water.ledger();
    EXPECT_GT(ledger.supplied, 0.4);
    EXPECT_LT(std::abs(ledger.imbalance()), 1e-6 * ledger.supplied);
    for (std::size_t n = 0; n < water.size(); ++n) {
        EXPECT_GE(water.filmMass()[n], 0.0);
        EXPECT_GE(water.saturation(n), 0.0);
        EXPECT_LE(water.saturation(n), 1.0);
    }
}

TEST(Moisture, RefusesWhatIsNoWaterAndStaysAsItWas) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    Moisture water(fabrics::cottonPlain(), {0.01, 0.0});
    water.addFilm(0, 1e-3);
    EXPECT_THROW(water.addFilm(0, -1e-3), std::invalid_argument);
    EXPECT_THROW(water.addFilm(0, nan), std::invalid_argument);
    EXPECT_THROW(water.addFilm(1, 1e-3), std::invalid_argument);  // a node without cloth
    EXPECT_THROW(water.addFilm(2, 1e-3), std::out_of_range);
    EXPECT_THROW(water.step(-0.1), std::invalid_argument);
    EXPECT_THROW(water.step(nan), std::invalid_argument);
    EXPECT_EQ(water.totalFilmMass(), 1e-3);
    EXPECT_EQ(water.ledger().supplied, 1e-3);
    EXPECT_EQ(water.content(1), 0.0);
    EXPECT_EQ(water.saturation(1), 0.0);
    EXPECT_EQ(water.filmThickness(1), 0.0);
    EXPECT_THROW(Moisture(fabrics::cottonPlain(), {0.01, -0.01}), std::invalid_argument);
    EXPECT_THROW(Moisture(fabrics::cottonPlain(), {nan}), std::invalid_argument);
}

}  // namespace
}  // namespace drench
