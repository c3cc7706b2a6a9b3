// Where a sheet is, as the water wants to know it.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <Eigen/Core>
#include <vector>

#include "drench/cloth_mesh.h"
#include "drench/precision.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// Read from the body at the start of each substep.
struct Pose {
    explicit Pose(const ClothMesh& mesh);

    /// Reads gravity, and the heights of the nodes above the first along it.
    void gatherHeights(const btSoftBody& body, std::vector<float>& heights);
    /// Reads positions and velocities.
    void gatherMotion(const btSoftBody& body);

    Eigen::Vector3d up = Eigen::Vector3d::Zero();   // against gravity; zero without
    double gravity = 0;                             // m/s2
    std::vector<Eigen::Vector3d> positions;         // m
    std::vector<Eigen::Vector3d> velocities;        // m/s
    std::vector<std::vector<int>> trianglesAround;  // indices, of each node
};

/// Mean velocity of a body's cloth, m/s, by its nodes' areas.
Eigen::Vector3d meanVelocity(const btSoftBody& body, const ClothMesh& mesh);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
