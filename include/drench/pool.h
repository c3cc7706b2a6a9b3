// A pool of still water: it wets, drags and lifts cloth.
#pragma once

#include <Eigen/Core>
#include <string>

#include "drench/config.h"
#include "drench/source.h"

namespace drench {

/// Still water with a level surface, coupled one way: the cloth does not move the water, and the pool stays full.
///
/// Wetting. Nodes below the level, nodes up to 2.7 mm above it (the capillary length of water, textbook) and floating
/// cloth get a film; the pores absorb it with the fabric's wetting time. A node that leaves the pool keeps a film of
/// the thickness of Landau & Levich (1942), 0.94 (gamma / (rho g))^1/2 (mu U / gamma)^2/3 with U the speed of the
/// cloth; at least the retained film, at most the largest film that a face carries, and at most what has not run off by
/// the end of the step, (mu L / (rho g dt))^1/2 with L the square root of the sheet's area (Jeffreys 1930), which
/// matters for steps of several seconds of water time. The rest of the film returns to the pool.
///
/// Drag, as in air (see AirDrag), with the density of water and the fabric's permeability to water, which is assumed to
/// be the same through the cloth as along it. Added mass per area for motion normal to the cloth: pi/4 rho L, as for a
/// plate of width L (Lamb 1932), with L the smaller of the square root of the sheet's area and 0.1 m (assumed).
///
/// Buoyancy: the weight of the water displaced by fibre, pores and film. Drag and buoyancy act in proportion to
/// `submergedFraction`, which is above 0 up to 1 cm above the level. Dry cloth floats until its pores have filled
/// (cotton: to three quarters) and then sinks. Water that the cloth takes up is at rest, and slows it.
///
/// A change of `level` does not give the water a velocity. Drag and buoyancy use the body's time, wetting the water's
/// time (SheetSettings::waterSpeed); with a water speed above about 1e4, film and pores fill and empty within one step
/// and cloth in the pool jitters. Without gravity a pool has no effect.
class DRENCH_API Pool final : public Source {
  public:
    /// Height of the surface, m; -1e9 to 1e9: the scalar product of a point on the surface and the upward unit vector,
    /// which is opposite to the sheet's gravity.
    double level;
    /// Lower corner of the rectangle that the pool fills, m; -1e9 to 1e9; default unbounded. Its coordinates are along
    /// the two horizontal world axes: x and z if y is up, x and y if z is up, y and z if x is up. With tilted gravity:
    /// the two axes that are nearest to horizontal, projected onto the surface.
    Eigen::Vector2d from = Eigen::Vector2d::Constant(-1e9);
    /// Upper corner of the rectangle, m; -1e9 to 1e9; default unbounded.
    Eigen::Vector2d to = Eigen::Vector2d::Constant(1e9);

    /// A pool without bounds. @param initialLevel  first value of `level`
    explicit Pool(double initialLevel) : level(initialLevel) {}
    std::string name() const override { return "pool"; }
    void supply(const SheetPose& sheet, double dt, Supply& supply) override;
};

}  // namespace drench
