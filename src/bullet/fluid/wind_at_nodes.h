// The wind at each node of a sheet.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "bullet/sheet/pose.h"
#include "bullet/simd/nodes.h"
#include "drench/air.h"
#include "drench/cloth_mesh.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

class BulletPass;

// Reads the air's field on a coarse lattice around the sheet and keeps the wind off what is behind solids.
class WindAtNodes {
  public:
    explicit WindAtNodes(const ClothMesh& mesh);

    // Where and when a sheet is.
    struct Moment {
        const Pose& pose;
        Eigen::Vector3d origin;  // of the pose's places, m
        double time;             // of the body, s
        double step;             // s
        const btCollisionWorld& world;
    };
    // @throws std::runtime_error for a field without a sensible velocity or length, and what the field throws;
    //     nothing that outlasts the step has then changed
    void evaluate(const Air& air, const Moment& moment);

    // m/s
    const std::vector<PackedVector>& velocities() const { return velocities_; }
    // Of the cloth, by its nodes' areas, m/s.
    const Eigen::Vector3d& mean() const { return mean_; }

  private:
    friend class BulletPass;
    void state(BulletPass& pass);

    static constexpr std::size_t maxPoints = 6;  // of the lattice along an axis

    // Nodes that are next to each other, and what is upwind of them.
    struct Patch {
        std::vector<std::size_t> nodes;
        std::size_t middle;   // node that the ray starts from
        double passing = 1;   // share of the wind that would pass if it stayed as it is
        double fraction = 1;  // that passes, 1
    };

    void fill(const Eigen::Vector3d& wind);
    void makePatches(const ClothMesh& mesh);
    void layLattice(double spacing, const Pose& pose);
    void readField(const Air& air, const Moment& moment);
    void interpolate(const Pose& pose);
    void askUpwind(double length, const Moment& moment);
    void shelter(double step);
    void average();

    std::vector<float> areas_;  // of nodes, m2
    std::vector<PackedVector> velocities_;
    Eigen::Vector3d mean_ = Eigen::Vector3d::Zero();
    bool isUniform_ = true;

    std::array<std::size_t, 3> points_ = {2, 2, 2};  // along each axis
    Eigen::Array4f low_ = Eigen::Array4f::Zero();    // corner of the lattice, m, as the pose's places
    Eigen::Array4f distance_ = Eigen::Array4f::Ones();
    std::array<PackedVector, maxPoints * maxPoints * maxPoints> lattice_{};  // m/s

    std::vector<Patch> patches_;
    std::size_t nextRay_ = 0;
    bool isSheltered_ = false;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
