// Depths of nodes under water, as reported by sources.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <cstddef>
#include <vector>

#include "bullet/simd/nodes.h"
#include "bullet/world/vectors.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

class BulletPass;

// Written by the sources of a sheet, read by the fluid forces in the same substep, then cleared.
class Submersion {
  public:
    explicit Submersion(std::size_t nodes)
        : isUnder_(nodes, 0), depths_(nodes, 0), velocities_(nodes, PackedVector{0, 0, 0, 0}) {}

    // If a node gets several depths, the greatest counts.
    void submerge(std::size_t node, double depth, const Eigen::Vector3d& velocity) {
        if (isUnder_[node] && !(float(depth) > depths_[node])) return;
        if (!isUnder_[node]) nodes_.push_back(node);
        isUnder_[node] = 1;
        depths_[node] = float(depth);
        velocities_[node] = {float(velocity.x()), float(velocity.y()), float(velocity.z()), 0};
    }
    void forget() {
        for (const std::size_t node : nodes_) isUnder_[node] = 0;
        nodes_.clear();
    }

    // Whether a depth of the node is known.
    bool knows(std::size_t node) const { return isUnder_[node] != 0; }
    // Nodes with a known depth.
    const std::vector<std::size_t>& nodes() const { return nodes_; }
    // Depth of such a node below the surface, m.
    float depth(std::size_t node) const { return depths_[node]; }
    // Velocity of the water there, m/s.
    const PackedVector& velocity(std::size_t node) const { return velocities_[node]; }

  private:
    friend class BulletPass;
    void state(BulletPass& pass);

    std::vector<char> isUnder_;
    std::vector<float> depths_;
    std::vector<PackedVector> velocities_;
    std::vector<std::size_t> nodes_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
