#include "drench/source.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace drench {

Eigen::Vector3d SheetPose::areaVector(std::size_t node) const {
    Eigen::Vector3d doubled = Eigen::Vector3d::Zero();
    for (const int triangle : trianglesAround[node]) {
        const auto& corners = mesh.triangles[static_cast<std::size_t>(triangle)];
        const Eigen::Vector3d& first = positions[static_cast<std::size_t>(corners[0])];
        const Eigen::Vector3d& second = positions[static_cast<std::size_t>(corners[1])];
        const Eigen::Vector3d& third = positions[static_cast<std::size_t>(corners[2])];
        doubled += (second - first).cross(third - first);
    }
    return doubled / 6;
}

double submergedFraction(double depth) {
    constexpr double zone = 0.02;  // m
    const double t = std::clamp(0.5 + depth / zone, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

}  // namespace drench
