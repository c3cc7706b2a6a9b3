// Finds the faces of two clothes, or of one, that cross.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "bullet/cloth_contact/crossing_faces.h"
#include "bullet/cloth_contact/surface_tree.h"

namespace drench {

// Two faces that cross, in the order of their trees.
struct CrossingPair {
    int face, other;
};

// Where a search ends even if there is more to be found.
struct CrossingLimits {
    std::int64_t pairs;  // that cross
    std::int64_t looks;  // at pairs of faces
};

class Crossings {
  public:
    // Of two clothes. @param offset  of the origin of the other from that of this one, m
    void find(const SurfaceTree& cloth, const SurfaceTree& other, const Eigen::Vector3d& offset,
              const CrossingLimits& limits);
    // Of one cloth with itself, but for faces that share a node.
    // @param looksEverywhere  if not, cloth that is hardly bent is taken not to cross itself: faster by far, but a sheet
    //     that is wound up evenly is overlooked
    void findWithin(const SurfaceTree& cloth, const CrossingLimits& limits, bool looksEverywhere);

    const std::vector<CrossingPair>& pairs() const { return pairs_; }
    // Whether the search did not end at a limit.
    bool areAll() const { return areAll_; }
    // How many pairs of faces it has looked at.
    std::int64_t looks() const { return looks_; }

    // Positions of the corners of a face, m.
    static FaceCorners cornersOf(const SurfaceTree& cloth, int face, const Eigen::Vector3d& offset);

  private:
    void begin(const SurfaceTree& cloth, const SurfaceTree& other, const Eigen::Vector3d& offset,
               const CrossingLimits& limits);
    void within(int branch);
    void between(int branch, int other);
    void betweenLeaves(const SurfaceTree::Leaf& leaf, const SurfaceTree::Leaf& other);
    void look(int face, int other);
    bool shareNode(int face, int other) const;

    const SurfaceTree* cloth_ = nullptr;
    const SurfaceTree* other_ = nullptr;
    Eigen::Vector3d offset_ = Eigen::Vector3d::Zero();
    Eigen::Array3f shift_ = Eigen::Array3f::Zero();  // the same
    float rounding_ = 0;                             // of boxes that are shifted, m
    CrossingLimits limits_ = {0, 0};
    bool looksEverywhere_ = true;
    bool areAll_ = true;
    std::int64_t looks_ = 0;
    std::vector<CrossingPair> pairs_;

    struct FaceBox {
        Eigen::Array3f low, high;
    };
    FaceBox boxOf(const SurfaceTree& cloth, int face) const;
    std::vector<FaceBox> boxes_;  // of the faces of a leaf
};

}  // namespace drench
