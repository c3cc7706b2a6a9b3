// What cloth rubs against and clings to.
#pragma once

#include "drench/export.h"
#include "drench/fabric.h"

namespace drench {

/// Kinds of surface that fabrics have numbers for.
enum class SurfaceKind {
    plate,  ///< smooth and hard: glass, metal, lacquer, plastic
    skin,   ///< human skin
    rough  ///< wood, stone, another cloth: as for a plate, but dry cloth catches on it (assumed; see `surfaceOf`)
};

/// How one fabric takes to one surface.
struct Surface {
    double frictionDry;     ///< friction coefficient of dry cloth, 1; 0 to 5
    double frictionDamp;    ///< the same where the pores are 60 % full or fuller
    double frictionSoaked;  ///< the same where a film between the two lubricates
    double wettability =
        1;  ///< share of the fabric's cling energy that holds there, 1; 0 to 1; default all of it
};

/// A fabric on a surface of that kind. On a rough one dry cloth has twice the friction that it has on a plate, at
/// least that of damp cloth there; soaked cloth has the mean of damp and soaked, as asperities reach through
/// the film; and a third of the cling energy, as the two touch in places only (all assumed).
DRENCH_API Surface surfaceOf(const Fabric& fabric, SurfaceKind kind);

/// @throws std::invalid_argument that names the value and its range
DRENCH_API void validate(const Surface& surface);

/// Friction coefficient of a piece of cloth, 1. Rises from dry to damp up to a pore saturation of 0.6 (measured
/// in shape), and falls to soaked as the film on the face grows from 18 um, which a face retains, to 0.1 mm,
/// where it lubricates (assumed in numbers). Smooth, so that nothing jerks.
/// @param saturation     of the pores, 0 to 1
/// @param filmThickness  on one face, m
DRENCH_API double frictionCoefficient(const Surface& surface, double saturation, double filmThickness);

}  // namespace drench
