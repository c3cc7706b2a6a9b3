// Friction and adhesion of cloth on surfaces.
#pragma once

#include "drench/config.h"
#include "drench/fabric.h"

namespace drench {

/// Kinds of surface for which fabrics have values.
enum class SurfaceKind {
    plate,  ///< smooth and hard: glass, metal, lacquer, plastic
    skin,   ///< human skin
    rough   ///< wood, stone, another cloth; derived from plate (assumed; see `surfaceOf`)
};

/// Friction and adhesion of one fabric on one surface.
struct Surface {
    double frictionDry;      ///< friction coefficient of dry cloth; 0 to 5
    double frictionDamp;     ///< the same at a pore saturation of 0.6 or more; 0 to 5
    double frictionSoaked;   ///< the same when lubricated by a film; 0 to 5
    double wettability = 1;  ///< factor on `Fabric::clingEnergy`, dimensionless; 0 to 1; default 1
};

/// Friction and adhesion of a fabric on a kind of surface. Rough surfaces (all assumed): dry friction is twice that on
/// a plate and at least the damp one on a plate; soaked friction is the mean of damp and soaked on a plate, because
/// asperities reach through the film; the wettability is 1/3, because the contact area is smaller.
DRENCH_API Surface surfaceOf(const Fabric& fabric, SurfaceKind kind);

/// Checks the ranges of all members of `Surface`.
/// @throws std::invalid_argument that names the value and its range
DRENCH_API void validate(const Surface& surface);

/// Friction coefficient of wet cloth, dimensionless. Rises smoothly from dry to damp at a pore saturation of 0.6 (shape
/// measured), and falls smoothly to soaked as the film grows from 18 um, the retained film, to 0.1 mm (assumed).
/// @param saturation     of the pores, 0 to 1
/// @param filmThickness  on one face, m
DRENCH_API double frictionCoefficient(const Surface& surface, double saturation, double filmThickness);

}  // namespace drench
