#include <algorithm>
#include <array>
#include <cmath>

#include "checks/checks.h"
#include "drench/pool.h"
#include "drench/water.h"

namespace drench {

namespace {

void checkSettings(const Pool& pool) {
    checkRange("Pool::level", pool.level, "m", -1e9, 1e9);
    for (int axis = 0; axis < 2; ++axis) {
        checkRange("Pool::from", pool.from[axis], "m", -1e9, 1e9);
        checkRange("Pool::to", pool.to[axis], "m", -1e9, 1e9);
        if (pool.from[axis] > pool.to[axis])
            refuse("Pool::from is ", pool.from[axis], " m, beyond Pool::to, ", pool.to[axis],
                   " m; exchange them so that from is the smaller");
    }
}

// The world axis that is nearest to the upward direction; if several are equally near, y, then z.
int axisAlong(const Eigen::Vector3d& up) {
    int found = 1;
    for (const int axis : {2, 0})
        if (std::abs(up[axis]) > std::abs(up[found])) found = axis;
    return found;
}

// Unit vectors along the two edges of the rectangle; see Pool::from.
std::array<Eigen::Vector3d, 2> horizontalAxes(const Eigen::Vector3d& up) {
    const int along = axisAlong(up);
    Eigen::Vector3d first = Eigen::Vector3d::Unit(along == 0 ? 1 : 0);
    first = (first - first.dot(up) * up).normalized();
    Eigen::Vector3d second = Eigen::Vector3d::Unit(along == 2 ? 1 : 2);
    second -= second.dot(up) * up;
    second = (second - second.dot(first) * first).normalized();
    return {first, second};
}

// Film on a face that moves through the surface, m: the formula of Landau & Levich (1942) for a plate that is
// drawn out of a liquid. Without the film that runs off within the step; otherwise the cloth would alternate
// between heavy and light. After a time t that leaves (mu L / (rho g t))^1/2 at a distance L below the upper
// edge (Jeffreys 1930).
double drawnFilm(double speed, const SheetPose& sheet, double dt) {
    const double weight = waterDensity * sheet.gravity;
    const double capillaryLength = std::sqrt(waterSurfaceTension / weight);
    const double capillaryNumber = waterViscosity * speed / waterSurfaceTension;
    const double drawn = 0.94 * capillaryLength * std::cbrt(capillaryNumber * capillaryNumber);
    const double left = std::sqrt(waterViscosity * std::sqrt(sheet.totalArea) / (weight * dt));
    return std::clamp(std::min(drawn, left), retainedFilmThickness, thickestFilm);
}

// Water rises to cloth slightly above the surface as a meniscus. Floating cloth counts as in contact at any
// height, because thick cloth that is mostly air floats higher; with a tolerance for bobbing.
bool touches(double depth, double fraction, const SheetPose& sheet) {
    constexpr double meniscus = 2.7e-3;  // m: the capillary length, (gamma / (rho g))^1/2 on earth (textbook)
    constexpr double bobbing = 0.9;      // assumed
    return depth > -meniscus || fraction > bobbing * sheet.floatingFraction;
}

// The water that the pores lack is added to the film, from which they absorb it with the fabric's wetting
// time.
void wet(const SheetPose& sheet, std::size_t node, double dt, Supply& supply) {
    const double area = sheet.mesh.areas[node];
    const double missing = std::max(0.0, sheet.poreCapacity * area - sheet.poreMass[node]);
    const double soaking = missing * -std::expm1(-dt / sheet.wettingTime);
    const double drawn = 2 * waterDensity * area * drawnFilm(sheet.velocities[node].norm(), sheet, dt);
    const double surplus = sheet.filmMass[node] - (drawn + soaking);
    // At rest, as the pool is: if it arrived with the velocity of the cloth, vibrating cloth would gain
    // energy.
    if (surplus < 0) supply.addFilm(node, -surplus, Eigen::Vector3d::Zero());
    if (surplus > 0) supply.takeFilm(node, surplus);
    supply.cover(node, 1);
}

}  // namespace

void Pool::supply(const SheetPose& sheet, double dt, Supply& supply) {
    checkSettings(*this);
    checkStep(dt);
    // Without gravity a pool has no level surface.
    if (sheet.up.isZero() || !(sheet.gravity > 0)) return;
    const auto axes = horizontalAxes(sheet.up);
    for (std::size_t node = 0; node < sheet.mesh.size(); ++node) {
        const Eigen::Vector3d& position = sheet.positions[node];
        const Eigen::Vector2d across(position.dot(axes[0]), position.dot(axes[1]));
        const bool inside = (across.array() >= from.array()).all() && (across.array() <= to.array()).all();
        if (!inside || !(sheet.mesh.areas[node] > 0)) continue;
        const double depth = level - position.dot(sheet.up), fraction = submergedFraction(depth);
        if (!(fraction > 0)) continue;
        if (dt > 0 && touches(depth, fraction, sheet)) wet(sheet, node, dt, supply);
        supply.submerge(node, depth, Eigen::Vector3d::Zero());
    }
}

}  // namespace drench
