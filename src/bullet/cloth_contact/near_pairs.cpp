#include "bullet/cloth_contact/near_pairs.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace drench {

namespace {

template <typename Value>
const Value& at(const std::vector<Value>& values, int index) {
    return values[static_cast<std::size_t>(index)];
}

// A box that holds points.
struct Extent {
    Eigen::Array3f low, high;

    explicit Extent(const Eigen::Vector3f& point) : low(point.array()), high(point.array()) {}
    void take(const Eigen::Vector3f& point) {
        low = low.min(point.array());
        high = high.max(point.array());
    }
    bool misses(const Extent& other) const { return (low > other.high || high < other.low).any(); }
};

void sortByNode(std::vector<NearFace>& found) {
    std::sort(found.begin(), found.end(), [](const NearFace& a, const NearFace& b) {
        return std::tie(a.node, a.distance, a.face) < std::tie(b.node, b.distance, b.face);
    });
}

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
    nodes_.clear();
    nodesOfOther_.clear();
    edges_.clear();
}

void NearPairs::finish() {
    sortByNode(nodes_);
    sortByNode(nodesOfOther_);
    std::sort(edges_.begin(), edges_.end(), [](const NearEdges& a, const NearEdges& b) {
        return std::tie(a.edge, a.other) < std::tie(b.edge, b.other);
    });
}

void NearPairs::within(int branch) {
    if (SurfaceTree::pointToOneSide(at(cloth_->boxes(), branch))) return;
    const SurfaceTree::Branch& of = at(cloth_->branches(), branch);
    if (of.leaf >= 0) return;  // its faces are too close to each other to meet
    within(of.children[0]);
    within(of.children[1]);
    between(of.children[0], of.children[1]);
}

bool NearPairs::areApart(const Box& box, const Box& other) const {
    const Eigen::Array3f shift = offset_.array();
    return (box.low > other.high + shift + near_.ofFaces || box.high + near_.ofFaces < other.low + shift)
        .any();
}

void NearPairs::between(int branch, int other) {
    const Box &box = at(cloth_->boxes(), branch), &otherBox = at(other_->boxes(), other);
    if (areApart(box, otherBox)) return;
    const SurfaceTree::Branch &one = at(cloth_->branches(), branch), &two = at(other_->branches(), other);
    if (one.leaf >= 0 && two.leaf >= 0) {
        if (!isSkipped(branch, other)) betweenLeaves(branch, other);
        return;
    }
    const bool splitsOther =
        one.leaf >= 0 || (two.leaf < 0 && (otherBox.high - otherBox.low).matrix().squaredNorm() >
                                              (box.high - box.low).matrix().squaredNorm());
    for (int child = 0; child < 2; ++child)
        if (splitsOther)
            between(branch, two.children[child]);
        else
            between(one.children[child], other);
}

// Neighbouring pieces of a cloth are as near by nature. They meet only if the cloth bends back there.
bool NearPairs::isSkipped(int branch, int other) const {
    return cloth_ == other_ &&
           cloth_->areAdjacent(at(cloth_->branches(), branch).leaf, at(cloth_->branches(), other).leaf) &&
           SurfaceTree::pointToOneSide(
               SurfaceTree::together(at(cloth_->boxes(), branch), at(cloth_->boxes(), other)));
}

void NearPairs::betweenLeaves(int branch, int other) {
    const SurfaceTree::Leaf &one = at(cloth_->leaves(), at(cloth_->branches(), branch).leaf),
                            &two = at(other_->leaves(), at(other_->branches(), other).leaf);
    nodesNearFaces(*cloth_, one, *other_, two, offset_, nodes_);
    nodesNearFaces(*other_, two, *cloth_, one, -offset_, nodesOfOther_);
    const bool onlyBorders = areLevel(branch, other);
    if (!onlyBorders || one.hasBorder || two.hasBorder) edgesNearEdges(one, two, onlyBorders);
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
    return SurfaceTree::pointToOneSide(SurfaceTree::together(box, turned));
}

void NearPairs::nodesNearFaces(const SurfaceTree& ofNodes, const SurfaceTree::Leaf& nodes,
                               const SurfaceTree& ofFaces, const SurfaceTree::Leaf& faces,
                               const Eigen::Vector3f& offset, std::vector<NearFace>& found) const {
    if (nodes.firstNode == nodes.endNode) return;
    const bool isOneCloth = &ofNodes == &ofFaces;
    Extent around(at(ofNodes.positions(), at(ofNodes.nodes(), nodes.firstNode)));
    for (int i = nodes.firstNode; i < nodes.endNode; ++i)
        around.take(at(ofNodes.positions(), at(ofNodes.nodes(), i)));
    around.low -= near_.ofFaces;
    around.high += near_.ofFaces;
    for (int f = faces.firstFace; f < faces.endFace; ++f) {
        const SurfaceTree::Face& face = at(ofFaces.faces(), f);
        const Eigen::Vector3f a = at(ofFaces.positions(), face.nodes[0]) + offset,
                              b = at(ofFaces.positions(), face.nodes[1]) + offset,
                              c = at(ofFaces.positions(), face.nodes[2]) + offset;
        Extent extent(a);
        extent.take(b);
        extent.take(c);
        if (extent.misses(around)) continue;
        extent.low -= near_.ofFaces;
        extent.high += near_.ofFaces;
        const Eigen::Vector3f& normal = at(ofFaces.normals(), f);
        for (int i = nodes.firstNode; i < nodes.endNode; ++i) {
            const int node = at(ofNodes.nodes(), i);
            const Eigen::Vector3f& position = at(ofNodes.positions(), node);
            if ((position.array() < extent.low || position.array() > extent.high).any()) continue;
            if (std::abs(normal.dot(position - a)) > near_.ofFaces) continue;
            if (isOneCloth && std::any_of(face.nodes.begin(), face.nodes.end(),
                                          [&](int corner) { return ofNodes.areClose(node, corner); }))
                continue;
            const NearestOnFace nearest = nearestOnFace(position, a, b, c);
            const float distance = nearest.apart.norm();
            if (distance <= near_.ofFaces) found.push_back({node, f, distance, nearest});
        }
    }
}

void NearPairs::edgesNearEdges(const SurfaceTree::Leaf& edges, const SurfaceTree::Leaf& others,
                               bool onlyBorders) {
    const bool isOneCloth = cloth_ == other_;
    for (int e = edges.firstEdge; e < edges.endEdge; ++e) {
        const SurfaceTree::Edge& edge = at(cloth_->edges(), e);
        const std::array<int, 2>& ends = edge.nodes;
        const Eigen::Vector3f &from = at(cloth_->positions(), ends[0]),
                              &to = at(cloth_->positions(), ends[1]);
        Extent extent(from);
        extent.take(to);
        extent.low -= near_.ofEdges;
        extent.high += near_.ofEdges;
        for (int o = others.firstEdge; o < others.endEdge; ++o) {
            const SurfaceTree::Edge& other = at(other_->edges(), o);
            if (onlyBorders && !edge.isBorder() && !other.isBorder()) continue;
            const std::array<int, 2>& otherEnds = other.nodes;
            const Eigen::Vector3f otherFrom = at(other_->positions(), otherEnds[0]) + offset_,
                                  otherTo = at(other_->positions(), otherEnds[1]) + offset_;
            Extent otherExtent(otherFrom);
            otherExtent.take(otherTo);
            if (extent.misses(otherExtent)) continue;
            if (isOneCloth && std::any_of(ends.begin(), ends.end(), [&](int node) {
                    return cloth_->areClose(node, otherEnds[0]) || cloth_->areClose(node, otherEnds[1]);
                }))
                continue;
            const std::optional<NearestOfEdges> nearest = nearestOfEdges(from, to, otherFrom, otherTo);
            if (!nearest) continue;
            const float distance = nearest->apart.norm();
            if (distance <= near_.ofEdges) edges_.push_back({e, o, distance, *nearest});
        }
    }
}

}  // namespace drench
