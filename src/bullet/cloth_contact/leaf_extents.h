// The boxes of the faces and of the edges of a leaf, eight side by side.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "bullet/cloth_contact/surface_tree.h"

namespace drench {

// Boxes of eight things, to be compared at once with that of another.
class EightBoxes {
  public:
    // Far from everything, until they are set.
    EightBoxes();
    void set(int lane, const Eigen::Array3f& low, const Eigen::Array3f& high);
    // How far each is from a box along the axis along which they are farthest apart, m; negative where they overlap.
    Eigen::Array<float, 8, 1> distances(const Eigen::Array3f& low, const Eigen::Array3f& high) const;

  private:
    std::array<Eigen::Array<float, 8, 1>, 3> low_, high_;  // of each axis, m
};

class LeafExtents {
  public:
    void make(const SurfaceTree& cloth, const SurfaceTree::Leaf& leaf);

    // Calls a function with each face, or edge, whose box is within a distance of a box.
    // @param skipped  of which faces or edges of the leaf not, one bit each
    template <typename Function>
    void forFacesNear(const Eigen::Array3f& low, const Eigen::Array3f& high, float distance,
                      SurfaceTree::Bits skipped, Function function) const {
        forEachNear(faces_, firstFace_, low, high, distance, skipped, function);
    }
    template <typename Function>
    void forEdgesNear(const Eigen::Array3f& low, const Eigen::Array3f& high, float distance,
                      SurfaceTree::Bits skipped, Function function) const {
        for (int block = 0; block < edgeBlocks_; ++block)
            forEachNear(edges_[static_cast<std::size_t>(block)], firstEdge_ + 8 * block, low, high, distance,
                        skipped >> (8 * block), function);
    }

  private:
    template <typename Function>
    static void forEachNear(const EightBoxes& boxes, int first, const Eigen::Array3f& low,
                            const Eigen::Array3f& high, float distance, SurfaceTree::Bits skipped,
                            Function function) {
        const Eigen::Array<float, 8, 1> distances = boxes.distances(low, high);
        if (!(distances.minCoeff() <= distance)) return;
        for (int lane = 0; lane < 8; ++lane)
            if (distances[lane] <= distance && (skipped >> lane & 1) == 0) function(first + lane);
    }

    int firstFace_ = 0, firstEdge_ = 0, edgeBlocks_ = 0;
    EightBoxes faces_;
    std::array<EightBoxes, 3> edges_;  // of eight faces, at most
};

}  // namespace drench
