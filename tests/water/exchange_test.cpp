#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cloth/meshes.h"
#include "drench/drying.h"
#include "drench/moisture.h"

namespace drench::exchange_test {
namespace {

constexpr double rate = 1e-4 / 3.6;  // 100 g/(m2 h), as in a room

Surroundings room(double humidity = 0.65) {
    Surroundings around;
    around.dryingRate = rate;
    around.humidity = humidity;
    return around;
}

Moisture sheet(const Fabric& fabric, double area = 0.01) {
    return Moisture(fabric, meshes::separateNodes({area}));
}

void run(Moisture& water, double seconds, double dt, const Surroundings& around) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / dt)); ++i) water.step(dt, around);
}

TEST(VapourExchange, AWetSheetLosesTheDryingRate) {
    for (const double dt : {1e-3, 1.0, 60.0}) {
        Moisture water = sheet(fabrics::cottonPlain());
        water.addPores(0, water.poreCapacity(0));
        const double before = water.ledger().held;
        run(water, 120 * dt > 600 ? 600 : 120 * dt, dt, room());
        const double seconds = 120 * dt > 600 ? 600 : 120 * dt;
        EXPECT_NEAR((before - water.ledger().held) / (rate * 0.01 * seconds), 1, 1e-6) << "dt " << dt;
        EXPECT_NEAR(water.ledger().evaporated / (rate * 0.01 * seconds), 1, 1e-6) << "dt " << dt;
    }
}

TEST(VapourExchange, FilmGoesFirst) {
    // In a cloth that hardly takes water in, pores keep theirs as long as there is film.
    Fabric fabric = fabrics::cottonPlain();
    fabric.wettingTime = 1e5;
    Moisture water = sheet(fabric);
    water.addFilm(0, 1e-4);
    water.addPores(0, 0.5 * water.poreCapacity(0));
    const double pores = water.poreMass()[0];
    run(water, 100, 1, room());
    EXPECT_GE(water.poreMass()[0], pores);
    EXPECT_NEAR(water.ledger().evaporated, rate * 0.01 * 100, 1e-11);
    run(water, 1900, 1, room());
    EXPECT_EQ(water.totalFilmMass(), 0.0);
    EXPECT_LT(water.poreMass()[0], pores);
    EXPECT_NEAR(water.ledger().evaporated / (rate * 0.01 * 2000), 1,
                1e-6);  // no step is lost between the two
}

struct Drying {
    std::vector<double> moistureContent, slope;  // kg/kg, and its loss per second
};

Drying dryFromWet(const Fabric& fabric, double start, double dt, double seconds, double humidity) {
    Moisture water = sheet(fabric);
    water.addPores(0, start * fabric.arealDensity * 0.01);
    Drying drying;
    for (double t = 0; t < seconds; t += dt) {
        const double before = water.moistureContent(0);
        water.step(dt, room(humidity));
        drying.moistureContent.push_back(0.5 * (before + water.moistureContent(0)));
        drying.slope.push_back((before - water.moistureContent(0)) / dt);
    }
    return drying;
}

TEST(VapourExchange, TheConstantRateEndsAtTheBoundMaximum) {
    for (const std::string& name : fabrics::names()) {
        const Fabric fabric = fabrics::byName(name);
        const double full = rate / fabric.arealDensity;
        const double dt = 0.005 * fabric.boundMaximum / full;
        const Drying drying = dryFromWet(fabric, 2 * fabric.boundMaximum, dt, 1000 * dt, 0.40);
        ASSERT_GT(drying.moistureContent.front(), 1.9 * fabric.boundMaximum) << name;
        double knee = 0;  // content at which the rate has first fallen, by half a per cent
        for (std::size_t i = 0; i < drying.slope.size() && knee == 0; ++i) {
            if (drying.moistureContent[i] > 1.05 * fabric.boundMaximum) {
                EXPECT_NEAR(drying.slope[i] / full, 1, 1e-5) << name;
            }
            if (drying.slope[i] < 0.995 * full) knee = drying.moistureContent[i];
        }
        EXPECT_NEAR(knee / fabric.boundMaximum, 1, 0.05) << name;
        std::printf("  %s: knee at %.4f of the bound maximum\n", name.c_str(), knee / fabric.boundMaximum);
        for (std::size_t i = 1; i < drying.slope.size(); ++i)
            ASSERT_LE(drying.slope[i], drying.slope[i - 1] + 1e-4 * full)
                << name << ": the rate never grows again";
    }
}

TEST(VapourExchange, TheFallingRateFollowsTheActivity) {
    const Fabric cotton = fabrics::cottonPlain();
    const Isotherm isotherm(cotton);
    const Drying drying = dryFromWet(cotton, 0.3, 1, 4000, 0.5);
    int compared = 0;
    for (std::size_t i = 0; i < drying.moistureContent.size(); ++i) {
        if (drying.moistureContent[i] > 0.21 || drying.moistureContent[i] < 0.08) continue;
        ++compared;
        const double law =
            rate / cotton.arealDensity * (isotherm.activity(drying.moistureContent[i]) - 0.5) / 0.5;
        EXPECT_NEAR(drying.slope[i] / law, 1, 0.01) << drying.moistureContent[i];
    }
    EXPECT_GT(compared, 10);
}

TEST(VapourExchange, EndsInBalanceWithTheRoom) {
    for (const std::string& name : fabrics::names())
        for (const double humidity : {0.0, 0.3, 0.65, 0.95})
            for (const double dt : {1.0, 60.0}) {
                const Fabric fabric = fabrics::byName(name);
                Moisture wet = sheet(fabric), dry = sheet(fabric);
                wet.addPores(0, 0.5 * wet.poreCapacity(0));
                run(wet, 86400, dt, room(humidity));
                run(dry, 86400, dt, room(humidity));
                const double balance = Isotherm(fabric).moistureContent(humidity);
                EXPECT_NEAR(wet.moistureContent(0), balance, 0.01 * balance + 1e-4 * fabric.boundMaximum)
                    << name << " at " << humidity;
                EXPECT_NEAR(dry.moistureContent(0), balance, 0.01 * balance + 1e-6)
                    << name << " at " << humidity;
            }
    EXPECT_NEAR(Isotherm(fabrics::cottonPlain()).moistureContent(0.65), 0.075, 1e-9);
}

TEST(VapourExchange, DryClothInDampAirGainsAndTheLedgerSaysFromWhere) {
    const Fabric cotton = fabrics::cottonPlain();
    Moisture water = sheet(cotton);
    run(water, 20000, 1, room(0.65));
    const Ledger ledger = water.ledger();
    EXPECT_NEAR(water.moistureContent(0), 0.075, 0.00075);
    EXPECT_EQ(ledger.accounts[1].name, "humid air");
    EXPECT_EQ(ledger.accounts[1].supplied, ledger.supplied);
    EXPECT_NEAR(ledger.supplied, ledger.held + ledger.evaporated, 1e-12 * ledger.supplied);
    EXPECT_NEAR(ledger.held, 0.075 * 0.0015, 0.00075 * 0.0015);
    EXPECT_NEAR(ledger.accounts[1].supplied, ledger.held, 1e-3 * ledger.held);
    EXPECT_GE(ledger.evaporated, 0.0);
    EXPECT_LT(ledger.evaporated, 1e-3 * ledger.held);  // it gains, and that is all
}

TEST(VapourExchange, LongStepsNeverPassTheBalance) {
    for (const double dt : {60.0, 3600.0, 1e6})
        for (const double humidity : {0.0, 0.3, 0.65, 0.99}) {
            const double balance = Isotherm(fabrics::cottonPlain()).moistureContent(humidity);
            Moisture wet = sheet(fabrics::cottonPlain()), dry = sheet(fabrics::cottonPlain());
            wet.addPores(0, wet.poreCapacity(0));
            wet.addFilm(0, 1e-3);
            for (int i = 0; i < 100; ++i) {
                wet.step(dt, room(humidity));
                dry.step(dt, room(humidity));
                ASSERT_GE(wet.moistureContent(0), balance * (1 - 1e-5)) << "dt " << dt << " at " << humidity;
                ASSERT_LE(dry.moistureContent(0), balance * (1 + 1e-5)) << "dt " << dt << " at " << humidity;
            }
        }
}

TEST(VapourExchange, LongStepsDryAsShortOnes) {
    Moisture minutes = sheet(fabrics::cottonPlain()), seconds = sheet(fabrics::cottonPlain());
    minutes.addPores(0, minutes.poreCapacity(0));
    seconds.addPores(0, seconds.poreCapacity(0));
    for (int hour = 0; hour < 3; ++hour) {
        run(minutes, 3600, 60, room(0.4));
        run(seconds, 3600, 0.5, room(0.4));
        EXPECT_NEAR(minutes.moistureContent(0), seconds.moistureContent(0), 0.01) << "hour " << hour;
    }
}

TEST(VapourExchange, WhatIsCoveredDoesNotDry) {
    Moisture water = sheet(fabrics::cottonPlain());
    water.addPores(0, water.poreCapacity(0));
    water.addFilm(0, 1e-4);
    for (int i = 0; i < 100; ++i) {
        water.cover(0, 1);
        water.step(60, room());
    }
    EXPECT_EQ(water.ledger().evaporated, 0.0);
    Moisture dry = sheet(fabrics::cottonPlain());
    dry.cover(0, 1);
    dry.step(60, room());
    EXPECT_EQ(dry.ledger().supplied, 0.0);  // nor does it take from damp air
}

TEST(VapourExchange, ANodeWithoutClothStaysDry) {
    Moisture water(fabrics::cottonPlain(), meshes::separateNodes({0.01, 0.0}));
    run(water, 600, 1, room());
    EXPECT_EQ(water.poreMass()[1], 0.0);
    EXPECT_TRUE(std::isfinite(water.ledger().held));
}

TEST(VapourExchange, SealedFromTheAirNothingPasses) {
    Moisture water = sheet(fabrics::cottonPlain());
    water.addPores(0, 1e-4);
    Surroundings around = room();
    around.dryingRate = 0;
    run(water, 600, 1, around);
    EXPECT_EQ(water.ledger().held, 1e-4);
    EXPECT_EQ(water.ledger().evaporated, 0.0);
}

}  // namespace
}  // namespace drench::exchange_test
