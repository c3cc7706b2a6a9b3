#include "drench/drying.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace drench::drying_test {
namespace {

constexpr double sheetLength = 0.5;  // m, of the check table

Air airOf(double temperature, double humidity) {
    Air air;
    air.temperature = temperature;
    air.humidity = humidity;
    return air;
}

double gramsPerHour(const Evaporation& evaporation) {
    return evaporation.rate * 1000 * 3600;
}

// The message of the std::invalid_argument that the action throws, or "" if it throws none.
template <class Action>
std::string refusalOf(Action action) {
    try {
        action();
    } catch (const std::invalid_argument& problem) {
        return problem.what();
    }
    return "";
}

TEST(Evaporation, GivesTheReferenceTable) {
    // Reference values in g per m2 of cloth and hour for a sheet of 0.5 m, worked out from the same textbook formulas
    // apart from this code. They are rounded, and their constants of air are not on record, so 3 % are left.
    const std::vector<double> speeds = {0, 0.5, 1, 2, 3, 5};
    struct Row {
        Air air;
        std::vector<double> rates;
    };
    const std::vector<Row> rows = {{airOf(20, 0.65), {53, 83, 108, 141, 166, 204}},
                                   {airOf(25, 0.50), {104, 145, 187, 242, 284, 348}},
                                   {airOf(35, 0.30), {241, 288, 366, 470, 547, 669}}};
    for (const Row& row : rows)
        for (std::size_t i = 0; i < speeds.size(); ++i)
            EXPECT_NEAR(gramsPerHour(evaporation(row.air, speeds[i], sheetLength)), row.rates[i],
                        0.03 * row.rates[i])
                << row.air.temperature << " C, " << speeds[i] << " m/s";
}

TEST(Evaporation, AgreesWithTheMeasuredDryingOfClothInTheStandardClimate) {
    // Measured: 96 +- 12 g/(m2 h) at 20 C and 65 % in near still air. Neither the speed of that air nor the size of
    // the cloth is on record. We take 0.75 m/s, the middle of the 0.5 to 1 m/s that a ventilated room may have, and
    // 0.5 m. That choice matters: the formula stays within the measured band from 0.52 to 1.0 m/s only, and at exactly
    // 0 m/s it gives 53. A laboratory's specimen of 5 cm gets 84 in air at rest, 108 at 0.1 m/s. So this shows that
    // the measurement can be met, not that it is predicted.
    const Air standard;
    EXPECT_NEAR(gramsPerHour(evaporation(standard, 0.75, sheetLength)), 96, 12);
    EXPECT_NEAR(gramsPerHour(evaporation(standard, 0.55, sheetLength)), 96, 12);
    EXPECT_NEAR(gramsPerHour(evaporation(standard, 1.0, sheetLength)), 96, 12);
    EXPECT_LT(gramsPerHour(evaporation(standard, 0, sheetLength)), 96 - 12);
    constexpr double specimen = 0.05;
    EXPECT_NEAR(gramsPerHour(evaporation(standard, 0, specimen)), 96, 12);
    EXPECT_NEAR(gramsPerHour(evaporation(standard, 0.1, specimen)), 96, 12);
}

// Wet-bulb temperature at sea level by the fit of Stull (2011), independent of the formulas of the library.
double wetBulbOfStull(double celsius, double percent) {
    return celsius * std::atan(0.151977 * std::sqrt(percent + 8.313659)) + std::atan(celsius + percent) -
           std::atan(percent - 1.676331) +
           0.00391838 * std::pow(percent, 1.5) * std::atan(0.023101 * percent) - 4.686035;
}

TEST(Evaporation, SurfaceIsNearTheWetBulbTemperatureInWind) {
    // Radiation, which a psychrometer shields off, warms the cloth a little: hence within 1 degree.
    for (const double celsius : {10.0, 20.0, 25.0, 35.0})
        for (const double percent : {30.0, 50.0, 65.0, 90.0})
            EXPECT_NEAR(evaporation(airOf(celsius, percent / 100), 5, sheetLength).surfaceTemperature,
                        wetBulbOfStull(celsius, percent), 1)
                << celsius << " C, " << percent << " %";
    // Read off a psychrometric chart.
    EXPECT_NEAR(evaporation(airOf(20, 0.65), 5, sheetLength).surfaceTemperature, 15.9, 1);
    EXPECT_NEAR(evaporation(airOf(35, 0.30), 5, sheetLength).surfaceTemperature, 21.9, 1);
}

TEST(Evaporation, HeatOfConvectionAndRadiationPaysForTheVapour) {
    for (const double speed : {0.0, 0.3, 3.0, 30.0}) {
        const Evaporation result = evaporation(airOf(35, 0.30), speed, sheetLength);
        const double latentHeat = 2.501e6 - 2361 * result.surfaceTemperature;
        EXPECT_NEAR((result.heatTransfer + 5.5) * (35 - result.surfaceTemperature),
                    result.rate / 2 * latentHeat, 1e-6)
            << speed;
    }
}

TEST(Evaporation, ConvectionIsFreeThenLaminarThenTurbulent) {
    const Air standard;
    // Still: the larger of both kinds is the free one, 1.42 ((20 - T_s) / 0.5)^1/4.
    const Evaporation still = evaporation(standard, 0, sheetLength);
    EXPECT_NEAR(still.heatTransfer, 1.42 * std::pow((20 - still.surfaceTemperature) / 0.5, 0.25), 1e-9);
    EXPECT_GT(evaporation(standard, 0.01, sheetLength).heatTransfer, 0.99 * still.heatTransfer);
    // By hand, 1 m: at 7.6 m/s Re is 4.967e5, Nu = 0.664 x 704.8 x 0.8921 = 417.5, h_c = 417.5 x 0.0257.
    EXPECT_NEAR(evaporation(standard, 7.6, 1).heatTransfer, 10.73, 0.01);
    // At 7.7 m/s Re is 5.033e5, Nu = 0.037 x 36428 x 0.8921 = 1202. At 20 m/s Re is 1.307e6, Nu = 2580.
    EXPECT_NEAR(evaporation(standard, 7.7, 1).heatTransfer, 30.9, 0.1);
    EXPECT_NEAR(evaporation(standard, 20, 1).heatTransfer, 66.3, 0.1);
}

TEST(Evaporation, SaturatedAirTakesNothing) {
    for (const double celsius : {0.0, 20.0, 60.0})
        for (const double speed : {0.0, 1.0, 100.0}) {
            const Evaporation result = evaporation(airOf(celsius, 1), speed, sheetLength);
            EXPECT_EQ(result.rate, 0.0);
            EXPECT_NEAR(result.surfaceTemperature, celsius, 1e-9);
        }
}

TEST(Evaporation, NeverCondensesAndNeverWarmsTheCloth) {
    for (const double celsius : {0.0, 15.0, 60.0})
        for (const double humidity : {0.0, 0.5, 0.999, 1 - 1e-15})
            for (const double speed : {0.0, 1e-6, 1.0, 100.0})
                for (const double length : {1e-3, 1.0, 100.0}) {
                    const Evaporation result = evaporation(airOf(celsius, humidity), speed, length);
                    EXPECT_TRUE(std::isfinite(result.rate) && std::isfinite(result.heatTransfer));
                    EXPECT_GE(result.rate, 0.0);
                    EXPECT_LE(result.surfaceTemperature, celsius);
                    EXPECT_GT(result.surfaceTemperature, celsius - 59);
                }
}

TEST(Evaporation, VapourExchangeScalesTheRateAlone) {
    Air air;
    const Evaporation open = evaporation(air, 1, sheetLength);
    air.vapourExchange = 0.25;
    const Evaporation covered = evaporation(air, 1, sheetLength);
    EXPECT_DOUBLE_EQ(covered.rate, 0.25 * open.rate);
    EXPECT_DOUBLE_EQ(covered.surfaceTemperature, open.surfaceTemperature);
    air.vapourExchange = 0;
    EXPECT_EQ(evaporation(air, 1, sheetLength).rate, 0.0);
}

TEST(Evaporation, RefusalsNameTheValue) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const auto refusalOfAir = [](const Air& air) { return refusalOf([&] { validate(air); }); };
    EXPECT_EQ(refusalOfAir(Air()), "");
    for (const double wrong : {-1.0, 61.0, 293.0, none})
        EXPECT_NE(refusalOfAir(airOf(wrong, 0.5)).find("temperature"), std::string::npos) << wrong;
    for (const double wrong : {-0.1, 1.01, 65.0, none})
        EXPECT_NE(refusalOfAir(airOf(20, wrong)).find("humidity"), std::string::npos) << wrong;
    EXPECT_EQ(refusalOfAir(airOf(20, 65)), "drench: air humidity is 65; give a value from 0 to 1");

    for (const double wrong : {-0.1, 1.1, none}) {
        Air air;
        air.vapourExchange = wrong;
        EXPECT_NE(refusalOfAir(air).find("vapourExchange"), std::string::npos) << wrong;
    }
    Air storm;
    storm.wind.y() = std::numeric_limits<double>::infinity();
    EXPECT_NE(refusalOfAir(storm).find("wind"), std::string::npos);

    const auto refusalOfFlow = [](const Air& air, double speed, double length) {
        return refusalOf([&] { evaporation(air, speed, length); });
    };
    for (const double wrong : {-1.0, 100.1, none})
        EXPECT_NE(refusalOfFlow(Air(), wrong, 1).find("speed"), std::string::npos) << wrong;
    for (const double wrong : {0.0, 1e-4, 101.0, none})
        EXPECT_NE(refusalOfFlow(Air(), 1, wrong).find("length"), std::string::npos) << wrong;
    EXPECT_NE(refusalOfFlow(airOf(20, 65), 1, 1).find("humidity"), std::string::npos);
}

TEST(Isotherm, PassesThroughTheRegainAndTheBoundMaximum) {
    for (const std::string& name : fabrics::names()) {
        const Fabric fabric = fabrics::byName(name);
        const Isotherm isotherm(fabric);
        EXPECT_NEAR(isotherm.moistureContent(0.65), fabric.regain, 1e-12) << name;
        EXPECT_NEAR(isotherm.moistureContent(1), fabric.boundMaximum, 1e-12) << name;
        EXPECT_EQ(isotherm.moistureContent(0), 0.0) << name;
        EXPECT_EQ(isotherm.firstLayerConstant(), 10.0);
    }
    // Cotton at 65 % holds 7 to 8.5 % of water (measured).
    const double cotton = Isotherm(fabrics::cottonPlain()).moistureContent(0.65);
    EXPECT_GT(cotton, 0.07);
    EXPECT_LT(cotton, 0.085);
}

TEST(Isotherm, FollowsTheFormulaOfGuggenheimAndersonDeBoer) {
    const Isotherm cotton(fabrics::cottonPlain());
    // Close to usual values for cotton, X 0.035 and k 0.85.
    EXPECT_NEAR(cotton.monolayer(), 0.0372, 1e-4);
    EXPECT_NEAR(cotton.multilayerConstant(), 0.834, 1e-3);
    // By hand at 30 %: y = 0.834 x 0.3 = 0.2502, W = 0.0372 x 2.502 / (0.7498 x 3.2518).
    EXPECT_NEAR(cotton.moistureContent(0.30), 0.0382, 1e-4);
}

TEST(Isotherm, ActivityIsTheInverseOfContent) {
    for (const std::string& name : fabrics::names()) {
        const Isotherm isotherm(fabrics::byName(name));
        for (int i = 1; i <= 1000; ++i) {
            const double humidity = 0.001 * i;
            EXPECT_NEAR(isotherm.activity(isotherm.moistureContent(humidity)), humidity, 1e-12) << name;
            EXPECT_GT(isotherm.moistureContent(humidity), isotherm.moistureContent(humidity - 0.001)) << name;
        }
    }
}

TEST(Isotherm, ActivityRisesWithContentAndStaysBetweenZeroAndOne) {
    for (const std::string& name : fabrics::names()) {
        const Fabric fabric = fabrics::byName(name);
        const Isotherm isotherm(fabric);
        for (int i = 0; i < 1000; ++i) {
            const double moistureContent = 0.001 * i * fabric.boundMaximum;
            EXPECT_LT(isotherm.activity(moistureContent),
                      isotherm.activity(moistureContent + 0.001 * fabric.boundMaximum));
        }
        EXPECT_EQ(isotherm.activity(0), 0.0);
        EXPECT_EQ(isotherm.activity(-0.1), 0.0);
        EXPECT_EQ(isotherm.activity(1.001 * fabric.boundMaximum), 1.0);
        EXPECT_EQ(isotherm.activity(10), 1.0);
    }
}

TEST(Isotherm, ActivityKeepsItsDigitsAtTracesOfWater) {
    const Isotherm isotherm(fabrics::wool());
    // Nearly dry, the isotherm is the line W = X c k a.
    const double slope = isotherm.monolayer() * isotherm.firstLayerConstant() * isotherm.multilayerConstant();
    for (const double moistureContent : {1e-9, 1e-12, 1e-15, 1e-200})
        EXPECT_NEAR(isotherm.activity(moistureContent) * slope / moistureContent, 1, 1e-6) << moistureContent;
}

TEST(Isotherm, HumidityIsClamped) {
    const Isotherm isotherm(fabrics::linen());
    EXPECT_EQ(isotherm.moistureContent(-0.5), 0.0);
    EXPECT_EQ(isotherm.moistureContent(1.5), isotherm.moistureContent(1));
}

TEST(Isotherm, TakesFabricsAtTheEdgesOfTheirRange) {
    // No isotherm of this kind starts at a regain of 0: it comes as close as k allows.
    Fabric repellent = fabrics::polyesterPlain();
    repellent.regain = 0;
    const Isotherm steepest(repellent);
    EXPECT_EQ(steepest.multilayerConstant(), 0.999);
    EXPECT_NEAR(steepest.moistureContent(1), 0.02, 1e-12);
    EXPECT_LT(steepest.moistureContent(0.65), 0.02 / 300);

    Fabric flat = fabrics::cottonPlain();
    flat.boundMaximum = 0.16;
    flat.regain = 0.0999;
    const Isotherm flattest(flat);
    EXPECT_NEAR(flattest.moistureContent(0.65), 0.0999, 1e-12);
    EXPECT_NEAR(flattest.moistureContent(1), 0.16, 1e-12);
}

TEST(Isotherm, RefusesAFabricOutOfRange) {
    Fabric fabric = fabrics::cottonPlain();
    fabric.regain = 0.2;
    EXPECT_NE(refusalOf([&] { Isotherm{fabric}; }).find("regain"), std::string::npos);
}

}  // namespace
}  // namespace drench::drying_test
