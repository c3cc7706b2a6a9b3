#include "bullet/cloth_contact/leaf_extents.h"

#include <limits>

namespace drench {

EightBoxes::EightBoxes() {
    constexpr float far = std::numeric_limits<float>::max();
    for (auto& axis : low_) axis.setConstant(far);
    for (auto& axis : high_) axis.setConstant(-far);
}

void EightBoxes::set(int lane, const Eigen::Array3f& low, const Eigen::Array3f& high) {
    for (int axis = 0; axis < 3; ++axis) {
        low_[static_cast<std::size_t>(axis)][lane] = low[axis];
        high_[static_cast<std::size_t>(axis)][lane] = high[axis];
    }
}

Eigen::Array<float, 8, 1> EightBoxes::distances(const Eigen::Array3f& low, const Eigen::Array3f& high) const {
    Eigen::Array<float, 8, 1> most = (low_[0] - high[0]).max(low[0] - high_[0]);
    most = most.max(low_[1] - high[1]).max(low[1] - high_[1]);
    return most.max(low_[2] - high[2]).max(low[2] - high_[2]);
}

void LeafExtents::make(const SurfaceTree& cloth, const SurfaceTree::Leaf& leaf) {
    const auto at = [&](int node) { return cloth.positions()[static_cast<std::size_t>(node)].array(); };
    firstFace_ = leaf.firstFace;
    firstEdge_ = leaf.firstEdge;
    faces_ = EightBoxes();
    for (int f = leaf.firstFace; f < leaf.endFace; ++f) {
        const auto& [a, b, c] = cloth.faces()[static_cast<std::size_t>(f)].nodes;
        faces_.set(f - leaf.firstFace, at(a).min(at(b)).min(at(c)), at(a).max(at(b)).max(at(c)));
    }
    edgeBlocks_ = (leaf.endEdge - leaf.firstEdge + 7) / 8;
    for (int block = 0; block < edgeBlocks_; ++block) edges_[static_cast<std::size_t>(block)] = EightBoxes();
    for (int e = leaf.firstEdge; e < leaf.endEdge; ++e) {
        const auto& [from, to] = cloth.edges()[static_cast<std::size_t>(e)].nodes;
        const int index = e - leaf.firstEdge;
        edges_[static_cast<std::size_t>(index / 8)].set(index % 8, at(from).min(at(to)),
                                                        at(from).max(at(to)));
    }
}

}  // namespace drench
