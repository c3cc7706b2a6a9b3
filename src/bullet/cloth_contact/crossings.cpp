#include "bullet/cloth_contact/crossings.h"

#include <algorithm>
#include <limits>

namespace drench {

namespace {

template <typename Value>
const Value& entryOf(const std::vector<Value>& values, int index) {
    return values[static_cast<std::size_t>(index)];
}

bool boxesAreApart(const Eigen::Array3f& low, const Eigen::Array3f& high, const Eigen::Array3f& otherLow,
                   const Eigen::Array3f& otherHigh) {
    return (low > otherHigh || high < otherLow).any();
}

}  // namespace

void Crossings::find(const SurfaceTree& cloth, const SurfaceTree& other, const Eigen::Vector3d& offset,
                     const CrossingLimits& limits) {
    begin(cloth, other, offset, limits);
    if (!cloth.branches().empty() && !other.branches().empty()) between(0, 0);
}

void Crossings::findWithin(const SurfaceTree& cloth, const CrossingLimits& limits, bool looksEverywhere) {
    begin(cloth, cloth, Eigen::Vector3d::Zero(), limits);
    looksEverywhere_ = looksEverywhere;
    if (!cloth.branches().empty()) within(0);
}

void Crossings::begin(const SurfaceTree& cloth, const SurfaceTree& other, const Eigen::Vector3d& offset,
                      const CrossingLimits& limits) {
    cloth_ = &cloth;
    other_ = &other;
    offset_ = offset;
    shift_ = offset.cast<float>().array();
    rounding_ = 0;
    limits_ = limits;
    areAll_ = true;
    looks_ = 0;
    pairs_.clear();
    if (shift_.isZero(0) || other.branches().empty()) return;
    const SurfaceTree::Box& box = other.boxes().front();
    const float farthest = std::max(box.low.abs().maxCoeff(), box.high.abs().maxCoeff());
    rounding_ = 2 * std::numeric_limits<float>::epsilon() * (shift_.abs().maxCoeff() + farthest);
}

void Crossings::within(int branch) {
    if (!areAll_ || (!looksEverywhere_ && cloth_->isOneSided(entryOf(cloth_->boxes(), branch)))) return;
    const SurfaceTree::Branch& of = entryOf(cloth_->branches(), branch);
    if (of.leaf >= 0) {
        const SurfaceTree::Leaf& leaf = entryOf(cloth_->leaves(), of.leaf);
        for (int face = leaf.firstFace; face < leaf.endFace; ++face)
            for (int other = face + 1; other < leaf.endFace && areAll_; ++other)
                if (!shareNode(face, other)) look(face, other);
        return;
    }
    within(of.children[0]);
    within(of.children[1]);
    between(of.children[0], of.children[1]);
}

void Crossings::between(int branch, int other) {
    const SurfaceTree::Box &box = entryOf(cloth_->boxes(), branch),
                           &otherBox = entryOf(other_->boxes(), other);
    const Eigen::Array3f low = otherBox.low + (shift_ - rounding_),
                         high = otherBox.high + (shift_ + rounding_);
    if (!areAll_ || boxesAreApart(box.low, box.high, low, high)) return;
    const SurfaceTree::Branch &one = entryOf(cloth_->branches(), branch),
                              &two = entryOf(other_->branches(), other);
    if (one.leaf >= 0 && two.leaf >= 0) {
        const bool isSkipped =
            cloth_ == other_ && !looksEverywhere_ && cloth_->areOneSidedNeighbours(one.leaf, two.leaf);
        if (!isSkipped)
            betweenLeaves(entryOf(cloth_->leaves(), one.leaf), entryOf(other_->leaves(), two.leaf));
        return;
    }
    cloth_->descend(*other_, branch, other, [this](int first, int second) { between(first, second); });
}

void Crossings::betweenLeaves(const SurfaceTree::Leaf& leaf, const SurfaceTree::Leaf& other) {
    const SurfaceTree::Box& whole = entryOf(cloth_->boxes(), leaf.branch);
    boxes_.clear();
    for (int face = leaf.firstFace; face < leaf.endFace; ++face) boxes_.push_back(boxOf(*cloth_, face));
    for (int second = other.firstFace; second < other.endFace; ++second) {
        FaceBox box = boxOf(*other_, second);
        box.low += shift_ - rounding_;
        box.high += shift_ + rounding_;
        if (boxesAreApart(box.low, box.high, whole.low, whole.high)) continue;
        for (int face = leaf.firstFace; face < leaf.endFace && areAll_; ++face) {
            const FaceBox& own = entryOf(boxes_, face - leaf.firstFace);
            if (boxesAreApart(own.low, own.high, box.low, box.high)) continue;
            if (cloth_ != other_ || !shareNode(face, second)) look(face, second);
        }
    }
}

void Crossings::look(int face, int other) {
    areAll_ = ++looks_ <= limits_.looks;
    if (!areAll_) return;
    if (!facesCross(cornersOf(*cloth_, face, Eigen::Vector3d::Zero()), cornersOf(*other_, other, offset_)))
        return;
    areAll_ = std::int64_t(pairs_.size()) < limits_.pairs;
    if (areAll_) pairs_.push_back({face, other});
}

bool Crossings::shareNode(int face, int other) const {
    const auto &nodes = entryOf(cloth_->faces(), face).nodes, &others = entryOf(other_->faces(), other).nodes;
    return std::any_of(nodes.begin(), nodes.end(),
                       [&](int node) { return node == others[0] || node == others[1] || node == others[2]; });
}

Crossings::FaceBox Crossings::boxOf(const SurfaceTree& cloth, int face) const {
    const auto& [a, b, c] = entryOf(cloth.faces(), face).nodes;
    const Eigen::Array3f one = entryOf(cloth.positions(), a).array(),
                         two = entryOf(cloth.positions(), b).array(),
                         three = entryOf(cloth.positions(), c).array();
    return {one.min(two).min(three), one.max(two).max(three)};
}

FaceCorners Crossings::cornersOf(const SurfaceTree& cloth, int face, const Eigen::Vector3d& offset) {
    FaceCorners corners;
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] =
            entryOf(cloth.positions(), entryOf(cloth.faces(), face).nodes[i]).cast<double>() + offset;
    return corners;
}

}  // namespace drench
