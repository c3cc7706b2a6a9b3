// Positions and velocities of a sheet, in the form that the water and the fluid forces use.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <Eigen/Core>
#include <vector>

#include "bullet/simd/nodes.h"
#include "bullet/world/vectors.h"
#include "drench/cloth_mesh.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Read from the body at the start of each substep.
struct Pose {
    explicit Pose(const ClothMesh& mesh);

    // Reads all node data that a substep needs, in a single pass over Bullet's nodes, each of which takes four
    // cache lines.
    // @param gravityOfBody  m/s2
    // @return whether all positions, velocities, forces and inverse masses are finite and in range; if not,
    //     positions are the last valid ones
    bool gather(const btSoftBody& body, const ClothMesh& mesh, const btVector3& gravityOfBody);
    // Positions of the nodes in the world, m.
    std::vector<btVector3> positionsInWorld() const;
    // Reads positions and velocities again, for sources.
    void gatherMotion(const btSoftBody& body);

    btVector3 origin = btVector3(0, 0, 0);  // of the relative positions, m: the first node
    std::vector<PackedVector>
        relativePositions;             // from the origin, m; precise also far from the world's origin
    std::vector<PackedVector> speeds;  // m/s
    std::vector<float> heights;        // of the nodes along `up`, m
    Eigen::Vector3d meanVelocity = Eigen::Vector3d::Zero();  // mean over the area of the cloth, m/s

    Eigen::Vector3d up = Eigen::Vector3d::Zero();   // opposite to gravity; zero without gravity
    double gravity = 0;                             // m/s2
    std::vector<Eigen::Vector3d> positions;         // m
    std::vector<Eigen::Vector3d> velocities;        // m/s
    std::vector<std::vector<int>> trianglesAround;  // indices of the triangles around each node

  private:
    std::vector<PackedVector> newRelativePositions_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
