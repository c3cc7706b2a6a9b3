// Where a sheet is, as the water wants to know it.
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

    // Reads gravity and, in one pass over Bullet's nodes, of which each takes four cache lines, what each
    // substep needs of them.
    // @return whether all positions, velocities, forces and inverse masses are such that one can calculate with
    //     them; if not, places are those of the last time that they were
    bool gather(const btSoftBody& body, const ClothMesh& mesh);
    // Where the nodes are, in the world, m.
    std::vector<btVector3> positionsInWorld() const;
    // Reads positions and velocities once more, for sources.
    void gatherMotion(const btSoftBody& body);

    btVector3 origin = btVector3(0, 0, 0);  // of the places, m: the first node
    std::vector<PackedVector>
        relativePositions;             // m, from there, so that far from the world's origin digits are kept
    std::vector<PackedVector> speeds;  // m/s
    std::vector<float> heights;        // m, of places along `up`
    Eigen::Vector3d meanVelocity = Eigen::Vector3d::Zero();  // of the cloth, by its nodes' areas, m/s

    Eigen::Vector3d up = Eigen::Vector3d::Zero();   // against gravity; zero without
    double gravity = 0;                             // m/s2
    std::vector<Eigen::Vector3d> positions;         // m
    std::vector<Eigen::Vector3d> velocities;        // m/s
    std::vector<std::vector<int>> trianglesAround;  // indices, of each node

  private:
    std::vector<PackedVector> newRelativePositions_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
