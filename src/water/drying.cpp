#include "drench/drying.h"

#include <algorithm>
#include <cmath>

#include "checks/checks.h"
#include "drench/water.h"

namespace drench {

namespace {

constexpr double airHeatCapacity = 1005;           // J/(kg K) (textbook)
constexpr double airConductivity = 0.0257;         // W/(m K) (textbook, 20 C)
constexpr double airKinematicViscosity = 1.53e-5;  // m2/s (textbook, 20 C)
constexpr double airPrandtlNumber = 0.71;          // 1 (textbook)
constexpr double lewisNumber = 0.85;               // 1 (textbook), of water vapour in air
constexpr double vapourGasConstant = 461.5;        // J/(kg K) (textbook)
constexpr double radiationCoefficient = 5.5;       // W/(m2 K) (textbook, near 20 C)
constexpr double turbulentReynoldsNumber = 5e5;    // 1 (textbook), of a flat plate

// Density of saturated vapour over liquid water, kg/m3. The pressure is the Magnus formula with the constants
// of Sonntag (1990).
double saturatedVapourDensity(double celsius) {
    const double pressure = 611.2 * std::exp(17.62 * celsius / (243.12 + celsius));
    return pressure / (vapourGasConstant * (celsius + 273.15));
}

// Latent heat of evaporation of water, J/kg.
double latentHeat(double celsius) {
    return 2.501e6 - 2361 * celsius;
}

// Heat transfer coefficient of a flat plate in a wind along it, W/(m2 K).
double forcedHeatTransfer(double speed, double length) {
    const double reynolds = speed * length / airKinematicViscosity;
    const double profile =
        reynolds < turbulentReynoldsNumber ? 0.664 * std::sqrt(reynolds) : 0.037 * std::pow(reynolds, 0.8);
    return profile * std::cbrt(airPrandtlNumber) * airConductivity / length;
}

// Heat transfer coefficient of a plate in still air, W/(m2 K), by free convection.
double freeHeatTransfer(double difference, double length) {
    return 1.42 * std::sqrt(std::sqrt(std::abs(difference) / length));
}

// One wet face in an air flow, for trial values of the surface temperature.
struct WetFace {
    const Air& air;
    double length;
    double forced;         // heat transfer coefficient of the wind, W/(m2 K)
    double vapourDensity;  // vapour density of the air far away, kg/m3
    double massOverHeat;   // mass over heat transfer coefficient, m3 K/J (Chilton & Colburn 1934)

    double heatTransfer(double celsius) const {
        return std::max(forced, freeHeatTransfer(air.temperature - celsius, length));
    }
    // Evaporation of this face, kg/(m2 s), at a vapour exchange of 1.
    double rate(double celsius) const {
        return heatTransfer(celsius) * massOverHeat * (saturatedVapourDensity(celsius) - vapourDensity);
    }
    // Net heat flow into the face: heat from the air minus latent heat, W/m2.
    double surplus(double celsius) const {
        const double incoming = (heatTransfer(celsius) + radiationCoefficient) * (air.temperature - celsius);
        return incoming - rate(celsius) * latentHeat(celsius);
    }
};

// Surface temperature at which the heat flows balance. The net heat flow over the heat transfer coefficient
// decreases monotonically with the surface temperature, so it has one zero. In air of 0 to 60 degrees a face
// never cools by 60 degrees, and 50 bisections of this interval leave 1e-13 degrees.
double balancedTemperature(const WetFace& face) {
    double cold = face.air.temperature - 60, warm = face.air.temperature;
    for (int halving = 0; halving < 50; ++halving) {
        const double middle = 0.5 * (cold + warm);
        (face.surplus(middle) > 0 ? cold : warm) = middle;
    }
    return 0.5 * (cold + warm);
}

// Constant c of the isotherm (assumed): the first layer of water is bound much more strongly than the others.
constexpr double assumedFirstLayerConstant = 10;
// The largest k. At k = 1 the moisture content in air of 100 % humidity would be infinite.
constexpr double largestMultilayerConstant = 0.999;
constexpr double standardHumidity = 0.65;  // humidity at which the regain of textiles is measured (textbook)

// Moisture content over that of the first layer, dimensionless.
double layers(double humidity, double c, double k) {
    const double y = k * humidity;
    return c * y / ((1 - y) * (1 - y + c * y));
}

// The k for which the isotherm has the given ratio of bound maximum to regain. The ratio is 1.54 at k = 0,
// falls to 1.3 at k = 0.2 and then increases without limit, so each ratio of 1.6 or more, which `validate`
// requires, has exactly one k.
double multilayerConstantOf(const Fabric& fabric, double c) {
    const auto reaches = [&](double k) {
        return layers(1, c, k) * fabric.regain >= layers(standardHumidity, c, k) * fabric.boundMaximum;
    };
    if (!reaches(largestMultilayerConstant)) return largestMultilayerConstant;
    double low = 0, high = largestMultilayerConstant;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (low + high);
        (reaches(middle) ? high : low) = middle;
    }
    return high;
}

}  // namespace

void validate(const Air& air) {
    checkRange("air temperature", air.temperature, "degrees Celsius", 0, 60);
    checkRange("air humidity", air.humidity, "", 0, 1);
    checkRange("vapourExchange of the air", air.vapourExchange, "", 0, 1);
    checkRange("shelterLength of the air", air.shelterLength, "m", 0, 1000);
    constexpr double fastest = 1e4;  // m/s
    if (air.wind.norm() <= fastest) return;
    refuse("air wind is ", air.wind, " m/s; give finite numbers, at most ", fastest, " m/s together");
}

Evaporation evaporation(const Air& air, double speed, double length) {
    validate(air);
    checkRange("air speed along the sheet", speed, "m/s", 0, 100);
    checkRange("length of the sheet along the air", length, "m", 1e-3, 100);

    const double lewisFactor = 1 / std::cbrt(lewisNumber * lewisNumber);
    const WetFace face = {air, length, forcedHeatTransfer(speed, length),
                          air.humidity * saturatedVapourDensity(air.temperature),
                          lewisFactor / (airDensity * airHeatCapacity)};
    const double temperature = balancedTemperature(face);
    // In saturated air the rate is zero except for rounding, which must not cause condensation.
    const double rate = std::max(0.0, 2 * face.rate(temperature) * air.vapourExchange);
    return {rate, temperature, face.heatTransfer(temperature)};
}

Isotherm::Isotherm(const Fabric& fabric) {
    validate(fabric);
    firstLayerConstant_ = assumedFirstLayerConstant;
    multilayerConstant_ = multilayerConstantOf(fabric, firstLayerConstant_);
    monolayer_ = fabric.boundMaximum / layers(1, firstLayerConstant_, multilayerConstant_);
}

double Isotherm::moistureContent(double humidity) const {
    return monolayer_ * layers(std::clamp(humidity, 0.0, 1.0), firstLayerConstant_, multilayerConstant_);
}

// The isotherm solved for y is (c - 1) W y^2 + B y - W = 0, B = X c - (c - 2) W. This form of its positive
// root has no division by a number that vanishes with W.
double Isotherm::activity(double moistureContent) const {
    if (moistureContent <= 0) return 0;
    const double c = firstLayerConstant_;
    const double linear = monolayer_ * c - (c - 2) * moistureContent;
    const double y = 2 * moistureContent /
                     (linear + std::sqrt(linear * linear + 4 * (c - 1) * moistureContent * moistureContent));
    return std::min(1.0, y / multilayerConstant_);
}

}  // namespace drench
