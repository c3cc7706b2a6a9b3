#include "bullet/repair/units.h"

#include <Eigen/Geometry>
#include <cmath>

#include "checks/text.h"
#include "drench/water.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

struct Unit {
    const char* name;
    double metres;
};

constexpr Unit units[] = {
    {"centimetres", 0.01}, {"millimetres", 0.001}, {"tenths of a metre", 0.1}, {"feet", 0.3048},
    {"inches", 0.0254},    {"units of 10 m", 10},  {"units of 100 m", 100},    {"kilometres", 1000},
};

// The unit of length in which the gravity of the earth has this value; null if there is none.
const Unit* unitOf(double gravity) {
    // 9.8, 9.81 and 10 are in use. A weak gravity of a round 1 or 0.1 m/s2 is a choice, though.
    constexpr double inUse = 0.025, exact = 0.005;
    for (const Unit& unit : units)
        if (std::abs(gravity * unit.metres / standardGravity - 1) < (unit.metres < 1 ? inUse : exact))
            return &unit;
    return nullptr;
}

}  // namespace

Eigen::Vector2d materialSize(const ClothMesh& mesh) {
    Eigen::AlignedBox2d extent;
    for (const auto& corners : mesh.coordinates)
        for (const Eigen::Vector2d& corner : corners) extent.extend(corner);
    return extent.sizes();
}

std::string wrongUnit(const ScaleSigns& signs) {
    constexpr double rounding = 1e-5, longest = 50 * (1 + rounding), shortest = 0.01 * (1 - rounding),
                     shortestLink = 1e-4 * (1 - rounding), strongest = 100;
    const double length = signs.size.maxCoeff();
    const Unit* const unit = unitOf(signs.gravity);
    const bool isLarge = length > longest, isSmall = length < shortest || signs.meanLink < shortestLink;
    if (!unit && !isLarge && !isSmall && !(signs.gravity > strongest)) return {};
    const char* const guess = unit      ? unit->name
                              : isLarge ? "centimetres or millimetres"
                              : isSmall ? "a world of reduced scale"
                                        : "another unit of length or time";
    const std::string mend =
        unit ? textOf("multiply all lengths by ", unit->metres, " and give a gravity of 9.81")
             : "give all lengths in metres and gravity in m/s2";
    return textOf("the sheet measures ", sixDigits(signs.size.x()), " x ", sixDigits(signs.size.y()),
                  " m with links of ", sixDigits(signs.meanLink), " m and weighs ", sixDigits(signs.mass),
                  " kg, and gravity is ", sixDigits(signs.gravity), " m/s2: this looks like ", guess,
                  "; Drench works in metres, kilograms and seconds, so ", mend,
                  ", or set SheetSettings::unusualScale if it is meant");
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
