#include "drench/fabric.h"

#include <algorithm>
#include <cmath>

#include "checks/checks.h"
#include "drench/water.h"

namespace drench {

std::string_view toString(Provenance provenance) {
    switch (provenance) {
        case Provenance::measured:
            return "measured";
        case Provenance::textbook:
            return "textbook";
        case Provenance::assumed:
            return "assumed";
        case Provenance::given:
            return "given";
    }
    return "unknown";
}

std::string_view toString(Construction construction) {
    switch (construction) {
        case Construction::plainWeave:
            return "plain weave";
        case Construction::twill:
            return "twill";
        case Construction::knit:
            return "knit";
    }
    return "unknown";
}

double Fabric::porosity() const {
    return 1.0 - arealDensity / (fibreDensity * thickness);
}

double Fabric::poreCapacity() const {
    return waterDensity * porosity() * thickness;
}

namespace {

// Room of the pores under a pressure over that without, by van Wyk's law, in which the pressure rises with the inverse
// cube of the room.
double roomRatioUnder(const Fabric& fabric, double pressure) {
    constexpr double pressureOfTest = 5000;  // Pa, of 50 gf/cm2
    const double porosity = fabric.porosity();
    const double pressed = (fabric.pressedThicknessRatio - (1 - porosity)) / porosity;
    const double softness = 1 / (pressed * pressed * pressed) - 1;
    return 1 / std::cbrt(1 + softness * pressure / pressureOfTest);
}

}  // namespace

double Fabric::thicknessUnder(double pressure) const {
    return thickness * (1 - porosity() + porosity() * roomRatioUnder(*this, pressure));
}

double Fabric::poreCapacityUnder(double pressure) const {
    const double room = poreCapacity() * roomRatioUnder(*this, pressure);
    const double held = pressure > entryPressure ? std::pow(entryPressure / pressure, poreSizeIndex) : 1.0;
    return std::min(std::max(room * held, boundMaximum * arealDensity), poreCapacity());
}

const std::vector<FabricParameter>& fabricParameters() {
    static const std::vector<FabricParameter> parameters = {
        {"arealDensity", "kg/m2", 0.01, 3, &Fabric::arealDensity},
        {"thickness", "m", 2e-5, 0.02, &Fabric::thickness},
        {"fibreDensity", "kg/m3", 700, 8000, &Fabric::fibreDensity},
        {"threadSpacing", "m", 5e-5, 0.02, &Fabric::threadSpacing},
        {"regain", "kg/kg", 0, 0.5, &Fabric::regain},
        {"boundMaximum", "kg/kg", 0.001, 1, &Fabric::boundMaximum},
        {"wettingTime", "s", 1e-3, 1e5, &Fabric::wettingTime},
        {"contactAngle", "degrees", 0, 179, &Fabric::contactAngle},
        {"entryPressure", "Pa", 1, 1e5, &Fabric::entryPressure},
        {"permeabilityWarp", "m2", 1e-16, 1e-8, &Fabric::permeabilityWarp},
        {"permeabilityWeft", "m2", 1e-16, 1e-8, &Fabric::permeabilityWeft},
        {"poreSizeIndex", "1", 0.2, 10, &Fabric::poreSizeIndex},
        {"stretchWarp", "N/m", 1, 1e6, &Fabric::stretchWarp},
        {"stretchWeft", "N/m", 1, 1e6, &Fabric::stretchWeft},
        {"shear", "N/m", 0.1, 1e6, &Fabric::shear},
        {"bending", "N m", 1e-9, 1, &Fabric::bending},
        {"bendingFriction", "N", 0, 1, &Fabric::bendingFriction},
        {"wetStretchRatio", "1", 0.01, 10, &Fabric::wetStretchRatio},
        {"wetBendingRatio", "1", 0.01, 10, &Fabric::wetBendingRatio},
        {"wetBendingFrictionRatio", "1", 0.01, 10, &Fabric::wetBendingFrictionRatio},
        {"plateFrictionDry", "1", 0, 5, &Fabric::plateFrictionDry},
        {"plateFrictionDamp", "1", 0, 5, &Fabric::plateFrictionDamp},
        {"plateFrictionSoaked", "1", 0, 5, &Fabric::plateFrictionSoaked},
        {"skinFrictionDry", "1", 0, 5, &Fabric::skinFrictionDry},
        {"skinFrictionDamp", "1", 0, 5, &Fabric::skinFrictionDamp},
        {"skinFrictionSoaked", "1", 0, 5, &Fabric::skinFrictionSoaked},
        {"clingEnergy", "J/m2", 0, 0.146, &Fabric::clingEnergy},
        {"airPermeabilityDry", "m/s at 100 Pa", 0, 10, &Fabric::airPermeabilityDry},
        {"airPermeabilitySaturated", "m/s at 100 Pa", 0, 10, &Fabric::airPermeabilitySaturated},
        {"albedoRed", "1", 0.001, 0.99, &Fabric::albedoRed},
        {"albedoGreen", "1", 0.001, 0.99, &Fabric::albedoGreen},
        {"albedoBlue", "1", 0.001, 0.99, &Fabric::albedoBlue},
        {"scattering", "1", 0.01, 1000, &Fabric::scattering},
        {"scatteringLoss", "1", 1, 100, &Fabric::scatteringLoss},
        {"permeabilityThrough", "m2", 1e-17, 1e-8, &Fabric::permeabilityThrough},
        {"pressedThicknessRatio", "1", 0.02, 1, &Fabric::pressedThicknessRatio},
    };
    return parameters;
}

namespace {

template <typename... Parts>
[[noreturn]] void refuseFabric(const Fabric& fabric, const Parts&... parts) {
    refuse("fabric ", inQuotes(fabric.name), ": ", parts...);
}

void checkParameter(const Fabric& fabric, const FabricParameter& parameter) {
    const double value = fabric.*parameter.member;
    if (std::isfinite(value) && value >= parameter.minimum && value <= parameter.maximum) return;
    refuseFabric(fabric, parameter.name, " is ", value, " ", parameter.unit, "; give a value from ",
                 parameter.minimum, " to ", parameter.maximum);
}

// Smallest ratio of bound maximum to regain. Slightly below it, at 1.54, more than one isotherm of the kind
// used for drying passes through both points; below 1.3 none does.
constexpr double minBoundOverRegain = 1.6;

}  // namespace

void validate(const Fabric& fabric) {
    if (fabric.name.empty()) refuse("a fabric has no name; set Fabric::name");
    for (const FabricParameter& parameter : fabricParameters()) checkParameter(fabric, parameter);

    const double porosity = fabric.porosity();
    if (porosity <= 0.01 || porosity >= 0.999)
        refuseFabric(fabric, "arealDensity ", fabric.arealDensity, " kg/m2, thickness ", fabric.thickness,
                     " m and fibreDensity ", fabric.fibreDensity, " kg/m3 leave a porosity of ",
                     sixDigits(porosity),
                     "; it must lie between 0.01 and 0.999, so mend the thickness or the areal density");
    constexpr double leastPores = 0.01;
    if (fabric.pressedThicknessRatio < 1 - porosity + leastPores * porosity)
        refuseFabric(fabric, "pressedThicknessRatio is ", fabric.pressedThicknessRatio,
                     "; it must be more than the fibres alone take up, ", sixDigits(1 - porosity),
                     " of the thickness, so raise it, up to 1, or mend the thickness");
    if (fabric.boundMaximum < minBoundOverRegain * fabric.regain)
        refuseFabric(fabric, "boundMaximum is ", fabric.boundMaximum, " kg/kg and regain ", fabric.regain,
                     " kg/kg; boundMaximum must be at least ", minBoundOverRegain,
                     " times regain, so raise boundMaximum or lower regain");
    if (fabric.shear >= fabric.stretchWarp || fabric.shear >= fabric.stretchWeft)
        refuseFabric(fabric, "shear is ", fabric.shear,
                     " N/m; it must be smaller than stretchWarp and stretchWeft, which contain it");
    if (fabric.airPermeabilitySaturated > fabric.airPermeabilityDry)
        refuseFabric(fabric, "airPermeabilitySaturated is ", fabric.airPermeabilitySaturated,
                     " m/s; it must not exceed airPermeabilityDry, ", fabric.airPermeabilityDry);
}

}  // namespace drench
