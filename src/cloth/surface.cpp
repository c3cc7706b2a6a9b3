#include "drench/surface.h"

#include <algorithm>
#include <stdexcept>

#include "checks/checks.h"
#include "drench/water.h"

namespace drench {

namespace {

// Rises from 0 at `from` to 1 at `to`, with slope 0 at both ends.
double smoothStep(double from, double to, double value) {
    const double x = std::clamp((value - from) / (to - from), 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

double between(double from, double to, double fraction) {
    return from + (to - from) * fraction;
}

}  // namespace

Surface surfaceOf(const Fabric& fabric, SurfaceKind kind) {
    if (kind == SurfaceKind::skin)
        return {fabric.skinFrictionDry, fabric.skinFrictionDamp, fabric.skinFrictionSoaked};
    const Surface plate = {fabric.plateFrictionDry, fabric.plateFrictionDamp, fabric.plateFrictionSoaked};
    if (kind == SurfaceKind::plate) return plate;
    constexpr double catching = 2, touchingFraction = 1.0 / 3, max = 5;
    const double dry = std::min(max, std::max(catching * plate.frictionDry, plate.frictionDamp));
    return {dry, std::max(dry, plate.frictionDamp), between(plate.frictionDamp, plate.frictionSoaked, 0.5),
            touchingFraction};
}

void validate(const Surface& surface) {
    checkRange("Surface::frictionDry", surface.frictionDry, "", 0, 5);
    checkRange("Surface::frictionDamp", surface.frictionDamp, "", 0, 5);
    checkRange("Surface::frictionSoaked", surface.frictionSoaked, "", 0, 5);
    checkRange("Surface::wettability", surface.wettability, "", 0, 1);
}

double frictionCoefficient(const Surface& surface, double saturation, double filmThickness) {
    constexpr double peak = 0.6, lubricating = 1e-4;
    const double damp = between(surface.frictionDry, surface.frictionDamp, smoothStep(0, peak, saturation));
    return between(damp, surface.frictionSoaked,
                   smoothStep(retainedFilmThickness, lubricating, filmThickness));
}

}  // namespace drench
