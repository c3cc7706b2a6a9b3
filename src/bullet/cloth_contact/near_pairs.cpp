#include "bullet/cloth_contact/near_pairs.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace drench {

namespace {

template <typename Value>
const Value& at(const std::vector<Value>& values, int index) {
    return values[static_cast<std::size_t>(index)];
}

// Layers whose normals are all within 60 degrees of some direction count as level.
constexpr float level = 0.5f;

}  // namespace

void NearPairs::find(const SurfaceTree& cloth, const SurfaceTree& other, const Eigen::Vector3f& offset,
                     const Distances& near) {
    begin(cloth, other, offset, near);
    if (!cloth.branches().empty() && !other.branches().empty()) between(0, 0);
    finish();
}

void NearPairs::findWithin(const SurfaceTree& cloth, const Distances& near) {
    begin(cloth, cloth, Eigen::Vector3f::Zero(), near);
    if (!cloth.branches().empty()) within(0);
    nodes_.insert(nodes_.end(), nodesOfOther_.begin(), nodesOfOther_.end());
    nodesOfOther_.clear();
    finish();
}

void NearPairs::begin(const SurfaceTree& cloth, const SurfaceTree& other, const Eigen::Vector3f& offset,
                      const Distances& near) {
    cloth_ = &cloth;
    other_ = &other;
    offset_ = offset;
    near_ = near;
    deviation_ = cloth.deviation() + other.deviation();
    ofCloth_.renew(cloth);
    if (&cloth != &other) ofOther_.renew(other);
    nodes_.clear();
    nodesOfOther_.clear();
    edges_.clear();
}

void NearPairs::LeafCache::renew(const SurfaceTree& cloth) {
    cloth_ = &cloth;
    ++present_;
    if (leaves_.size() < cloth.leaves().size()) leaves_.resize(cloth.leaves().size());
}

const LeafExtents& NearPairs::LeafCache::of(int leaf) {
    Leaf& cached = leaves_[static_cast<std::size_t>(leaf)];
    if (cached.madeFor != present_) cached.extents.make(*cloth_, at(cloth_->leaves(), leaf));
    cached.madeFor = present_;
    return cached.extents;
}

void NearPairs::finish() {
    sortByNode(nodes_, cloth_->nodeCount());
    sortByNode(nodesOfOther_, other_->nodeCount());
    std::sort(edges_.begin(), edges_.end(), [](const NearEdges& a, const NearEdges& b) {
        return std::tie(a.edge, a.other) < std::tie(b.edge, b.other);
    });
}

// There are many, but few of each node.
void NearPairs::sortByNode(std::vector<NearFace>& found, std::size_t nodes) {
    firstOf_.assign(nodes + 1, 0);
    for (const NearFace& each : found) ++firstOf_[static_cast<std::size_t>(each.node) + 1];
    std::partial_sum(firstOf_.begin(), firstOf_.end(), firstOf_.begin());
    unsorted_.swap(found);
    found.resize(unsorted_.size());
    for (const NearFace& each : unsorted_) found[firstOf_[static_cast<std::size_t>(each.node)]++] = each;
    // By now each is where those of the next node begin.
    auto first = found.begin();
    for (std::size_t node = 0; node < nodes; ++node) {
        const auto end = found.begin() + static_cast<std::ptrdiff_t>(firstOf_[node]);
        std::sort(first, end, [](const NearFace& a, const NearFace& b) {
            return std::tie(a.distance, a.face) < std::tie(b.distance, b.face);
        });
        first = end;
    }
}

void NearPairs::addNearest(const std::vector<int>& nodes, bool areOfOther, float farthest) {
    std::vector<NearFace>& found = areOfOther ? nodesOfOther_ : nodes_;
    const SurfaceTree &ofNode = areOfOther ? *other_ : *cloth_, &ofFace = areOfOther ? *cloth_ : *other_;
    if (ofFace.branches().empty()) return;
    const Eigen::Vector3f offset = areOfOther ? -offset_ : offset_;
    added_.clear();
    std::size_t next = 0;
    for (const int node : nodes) {
        while (next < found.size() && found[next].node < node) ++next;
        if (next < found.size() && found[next].node == node) continue;
        Nearest nearest = {&ofNode, &ofFace, at(ofNode.positions(), node) - offset, {node, -1, farthest, {}}};
        findNearest(nearest, 0);
        if (nearest.found.face >= 0) added_.push_back(nearest.found);
    }
    if (added_.empty()) return;
    found.insert(found.end(), added_.begin(), added_.end());
    sortByNode(found, ofNode.nodeCount());
}

void NearPairs::findNearest(Nearest& nearest, int branch) const {
    const SurfaceTree& tree = *nearest.ofFace;
    const Box& box = at(tree.boxes(), branch);
    const Eigen::Array3f place = nearest.position.array();
    const Eigen::Array3f outside = (box.low - place).max(place - box.high).max(0);
    if (!(outside.matrix().norm() < nearest.found.distance)) return;
    const SurfaceTree::Branch& of = at(tree.branches(), branch);
    if (of.leaf < 0) {
        for (const int child : of.children) findNearest(nearest, child);
        return;
    }
    const SurfaceTree::Leaf& leaf = at(tree.leaves(), of.leaf);
    const bool isOneCloth = nearest.ofNode == nearest.ofFace;
    const SurfaceTree::Bits close = isOneCloth ? tree.closeFaces(nearest.found.node, of.leaf) : 0;
    for (int f = leaf.firstFace; f < leaf.endFace; ++f) {
        if ((close >> (f - leaf.firstFace) & 1) != 0) continue;
        const auto& [a, b, c] = at(tree.faces(), f).nodes;
        const NearestOnFace point = nearestOnFace(nearest.position, at(tree.positions(), a),
                                                  at(tree.positions(), b), at(tree.positions(), c));
        const float distance = point.apart.norm();
        if (distance < nearest.found.distance) nearest.found = {nearest.found.node, f, distance, point};
    }
}

void NearPairs::within(int branch) {
    if (cloth_->isOneSided(at(cloth_->boxes(), branch))) return;
    const SurfaceTree::Branch& of = at(cloth_->branches(), branch);
    if (of.leaf >= 0) return;  // its faces are too close to each other to meet
    within(of.children[0]);
    within(of.children[1]);
    between(of.children[0], of.children[1]);
}

bool NearPairs::areApart(const Box& box, const Box& other, float near) const {
    const Eigen::Array3f shift = offset_.array();
    return (box.low > other.high + shift + near || box.high + near < other.low + shift).any();
}

// How far anything in one box may move towards anything in the other, m.
float NearPairs::approach(const Box& box, const Box& other) const {
    const Eigen::Array3f farthest =
        (box.highWay - other.lowWay).abs().max((box.lowWay - other.highWay).abs());
    return std::min(farthest.matrix().norm() + deviation_, near_.farthest);
}

// The same of a node towards any of a few nodes, or what is between them.
float NearPairs::approach(const Eigen::Vector3f& way, const SurfaceTree& other, const int* nodes,
                          int count) const {
    float farthest = 0;
    for (int i = 0; i < count; ++i)
        farthest = std::max(farthest, (way - at(other.ways(), nodes[i])).squaredNorm());
    return std::min(std::sqrt(farthest) + deviation_, near_.farthest);
}

void NearPairs::between(int branch, int other) {
    const Box &box = at(cloth_->boxes(), branch), &otherBox = at(other_->boxes(), other);
    if (areApart(box, otherBox, near_.ofFaces + approach(box, otherBox))) return;
    const SurfaceTree::Branch &one = at(cloth_->branches(), branch), &two = at(other_->branches(), other);
    if (one.leaf >= 0 && two.leaf >= 0) {
        if (!isSkipped(branch, other)) betweenLeaves(branch, other);
        return;
    }
    cloth_->descend(*other_, branch, other, [this](int first, int second) { between(first, second); });
}

// Neighbouring pieces of a cloth are as near by nature. They meet only if the cloth around them bends back.
bool NearPairs::isSkipped(int branch, int other) const {
    return cloth_ == other_ && cloth_->areOneSidedNeighbours(at(cloth_->branches(), branch).leaf,
                                                             at(cloth_->branches(), other).leaf);
}

void NearPairs::betweenLeaves(int branch, int other) {
    const int leaf = at(cloth_->branches(), branch).leaf, otherLeaf = at(other_->branches(), other).leaf;
    const Side one = {cloth_, leaf, &at(cloth_->leaves(), leaf), &at(cloth_->boxes(), branch),
                      &ofCloth_.of(leaf)};
    LeafCache& others = cloth_ == other_ ? ofCloth_ : ofOther_;
    const Side two = {other_, otherLeaf, &at(other_->leaves(), otherLeaf), &at(other_->boxes(), other),
                      &others.of(otherLeaf)};
    const float most = approach(*one.box, *two.box);
    nodesNearFaces(one, two, offset_, most, nodes_);
    nodesNearFaces(two, one, -offset_, most, nodesOfOther_);
    if (areApart(*one.box, *two.box, near_.ofEdges + most)) return;
    const bool onlyBorders = areLevel(branch, other);
    if (!onlyBorders || one.leaf->hasBorder || two.leaf->hasBorder)
        edgesNearEdges(one, two, most, onlyBorders);
}

// Level layers are kept apart by their nodes, except at the border of the cloth: an edge that comes nearer than the
// nodes of its face has to bend.
bool NearPairs::areLevel(int branch, int other) const {
    const Box& box = at(cloth_->boxes(), branch);
    Box turned = at(other_->boxes(), other);
    const Eigen::Array3f middle = box.lowNormal + box.highNormal;
    if ((middle * (turned.lowNormal + turned.highNormal)).sum() < 0) {
        const Eigen::Array3f low = -turned.highNormal;
        turned.highNormal = -turned.lowNormal;
        turned.lowNormal = low;
    }
    return SurfaceTree::pointToOneSide(SurfaceTree::together(box, turned), level);
}

// @param offset    of the faces, m
// @param approach  of anything in one leaf towards anything in the other, m
void NearPairs::nodesNearFaces(const Side& ofNodes, const Side& ofFaces, const Eigen::Vector3f& offset,
                               float approach, std::vector<NearFace>& found) const {
    const float farthest = near_.ofFaces + approach;
    const float nearest = near_.ofFaces + std::min(deviation_, near_.farthest);
    const Eigen::Array3f low = ofFaces.box->low - farthest, high = ofFaces.box->high + farthest;
    const std::vector<Eigen::Vector3f>& positions = ofFaces.cloth->positions();
    const bool isOneCloth = ofNodes.cloth == ofFaces.cloth;
    for (int i = ofNodes.leaf->firstNode; i < ofNodes.leaf->endNode; ++i) {
        const int node = at(ofNodes.cloth->nodes(), i);
        const Eigen::Vector3f position = at(ofNodes.cloth->positions(), node) - offset;
        if ((position.array() < low || position.array() > high).any()) continue;
        const Eigen::Vector3f& way = at(ofNodes.cloth->ways(), node);
        const SurfaceTree::Bits close = isOneCloth ? ofNodes.cloth->closeFaces(node, ofFaces.index) : 0;
        ofFaces.extents->forFacesNear(position.array(), position.array(), farthest, close, [&](int f) {
            const std::array<int, 3>& corners = at(ofFaces.cloth->faces(), f).nodes;
            const auto& [a, b, c] = corners;
            // Most that are found are near where they are.
            const float height = std::abs(at(ofFaces.cloth->normals(), f).dot(position - at(positions, a)));
            float near = nearest;
            if (height > near) near = near_.ofFaces + this->approach(way, *ofFaces.cloth, corners.data(), 3);
            if (height > near) return;
            const NearestOnFace point =
                nearestOnFace(position, at(positions, a), at(positions, b), at(positions, c));
            const float distance = point.apart.norm();
            if (distance > near && near == nearest)
                near = near_.ofFaces + this->approach(way, *ofFaces.cloth, corners.data(), 3);
            if (distance <= near) found.push_back({node, f, distance, point});
        });
    }
}

void NearPairs::edgesNearEdges(const Side& one, const Side& two, float approach, bool onlyBorders) {
    const Eigen::Array3f shift = offset_.array();
    const float farthest = near_.ofEdges + approach;
    one.extents->forEdgesNear(two.box->low + shift, two.box->high + shift, farthest, 0, [&](int e) {
        const SurfaceTree::Edge& edge = at(cloth_->edges(), e);
        const Eigen::Array3f from = at(cloth_->positions(), edge.nodes[0]).array() - shift,
                             to = at(cloth_->positions(), edge.nodes[1]).array() - shift;
        const SurfaceTree::Bits close = cloth_ == other_ ? cloth_->closeEdges(e, two.index) : 0;
        two.extents->forEdgesNear(from.min(to), from.max(to), farthest, close, [&](int o) {
            if (!onlyBorders || edge.isBorder() || at(other_->edges(), o).isBorder()) edgeNearEdge(e, o);
        });
    });
}

void NearPairs::edgeNearEdge(int edge, int other) {
    const std::array<int, 2>&ends = at(cloth_->edges(), edge).nodes,
                          &otherEnds = at(other_->edges(), other).nodes;
    const std::optional<NearestOfEdges> nearest = nearestOfEdges(
        at(cloth_->positions(), ends[0]), at(cloth_->positions(), ends[1]),
        at(other_->positions(), otherEnds[0]) + offset_, at(other_->positions(), otherEnds[1]) + offset_);
    if (!nearest) return;
    const float distance = nearest->apart.norm();
    if (distance > near_.ofEdges + near_.farthest) return;
    const auto approachOf = [&](int end) {
        return approach(at(cloth_->ways(), end), *other_, otherEnds.data(), 2);
    };
    if (distance <= near_.ofEdges + std::max(approachOf(ends[0]), approachOf(ends[1])))
        edges_.push_back({edge, other, distance, *nearest});
}

}  // namespace drench
