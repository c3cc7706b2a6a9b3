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

// Cloth whose normals are all within a right angle of some direction does not meet itself; a little less, to be sure.
constexpr float oneSided = 0.15f;
// Layers whose normals are all within 60 degrees of some direction count as level.
constexpr float level = 0.5f;

// A box that holds points.
struct Extent {
    Eigen::Array3f low, high;

    explicit Extent(const Eigen::Vector3f& point) : low(point.array()), high(point.array()) {}
    void take(const Eigen::Vector3f& point) {
        low = low.min(point.array());
        high = high.max(point.array());
    }
    void grow(float by) {
        low -= by;
        high += by;
    }
    bool misses(const Eigen::Vector3f& point) const {
        return (point.array() < low || point.array() > high).any();
    }
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
    if (SurfaceTree::pointToOneSide(at(cloth_->boxes(), branch), oneSided)) return;
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
               SurfaceTree::together(at(cloth_->boxes(), branch), at(cloth_->boxes(), other)), oneSided);
}

void NearPairs::betweenLeaves(int branch, int other) {
    const SurfaceTree::Leaf &one = at(cloth_->leaves(), at(cloth_->branches(), branch).leaf),
                            &two = at(other_->leaves(), at(other_->branches(), other).leaf);
    const Box &box = at(cloth_->boxes(), branch), &otherBox = at(other_->boxes(), other);
    nodesNearFaces(*cloth_, one, *other_, two, otherBox, offset_, nodes_);
    nodesNearFaces(*other_, two, *cloth_, one, box, -offset_, nodesOfOther_);
    const bool onlyBorders = areLevel(branch, other);
    if (!onlyBorders || one.hasBorder || two.hasBorder) edgesNearEdges(one, box, two, otherBox, onlyBorders);
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

void NearPairs::nodesNearFaces(const SurfaceTree& ofNodes, const SurfaceTree::Leaf& nodes,
                               const SurfaceTree& ofFaces, const SurfaceTree::Leaf& faces, const Box& ofLeaf,
                               const Eigen::Vector3f& offset, std::vector<NearFace>& found) {
    const Eigen::Array3f low = ofLeaf.low + offset.array() - near_.ofFaces,
                         high = ofLeaf.high + offset.array() + near_.ofFaces;
    candidates_.clear();
    for (int i = nodes.firstNode; i < nodes.endNode; ++i) {
        const Eigen::Array3f position = at(ofNodes.positions(), at(ofNodes.nodes(), i)).array();
        if ((position >= low && position <= high).all()) candidates_.push_back(at(ofNodes.nodes(), i));
    }
    if (candidates_.empty()) return;
    const bool isOneCloth = &ofNodes == &ofFaces;
    for (int f = faces.firstFace; f < faces.endFace; ++f) {
        const SurfaceTree::Face& face = at(ofFaces.faces(), f);
        const Eigen::Vector3f a = at(ofFaces.positions(), face.nodes[0]) + offset,
                              b = at(ofFaces.positions(), face.nodes[1]) + offset,
                              c = at(ofFaces.positions(), face.nodes[2]) + offset;
        Extent extent(a);
        extent.take(b);
        extent.take(c);
        extent.grow(near_.ofFaces);
        const Eigen::Vector3f& normal = at(ofFaces.normals(), f);
        for (const int node : candidates_) {
            const Eigen::Vector3f& position = at(ofNodes.positions(), node);
            if (extent.misses(position) || std::abs(normal.dot(position - a)) > near_.ofFaces) continue;
            if (isOneCloth && std::any_of(face.nodes.begin(), face.nodes.end(),
                                          [&](int corner) { return ofNodes.areClose(node, corner); }))
                continue;
            const NearestOnFace nearest = nearestOnFace(position, a, b, c);
            const float distance = nearest.apart.norm();
            if (distance <= near_.ofFaces) found.push_back({node, f, distance, nearest});
        }
    }
}

// Those of the edges of a leaf that are near a box, with their extents.
void NearPairs::edgesNear(const SurfaceTree& cloth, const SurfaceTree::Leaf& leaf, const Box& box,
                          const Eigen::Vector3f& offset, std::vector<NearEdge>& found) const {
    found.clear();
    const Eigen::Array3f low = box.low + offset.array() - near_.ofEdges,
                         high = box.high + offset.array() + near_.ofEdges;
    for (int e = leaf.firstEdge; e < leaf.endEdge; ++e) {
        const std::array<int, 2>& ends = at(cloth.edges(), e).nodes;
        const Eigen::Array3f from = at(cloth.positions(), ends[0]).array(),
                             to = at(cloth.positions(), ends[1]).array();
        const Eigen::Array3f least = from.min(to), most = from.max(to);
        if ((least <= high && most >= low).all()) found.push_back({e, least, most});
    }
}

void NearPairs::edgesNearEdges(const SurfaceTree::Leaf& edges, const Box& ofEdges,
                               const SurfaceTree::Leaf& others, const Box& ofOthers, bool onlyBorders) {
    edgesNear(*cloth_, edges, ofOthers, offset_, nearEdges_);
    if (nearEdges_.empty()) return;
    edgesNear(*other_, others, ofEdges, -offset_, nearOthers_);
    for (const NearEdge& near : nearEdges_) {
        const SurfaceTree::Edge& edge = at(cloth_->edges(), near.edge);
        const Eigen::Array3f low = near.low - offset_.array() - near_.ofEdges,
                             high = near.high - offset_.array() + near_.ofEdges;
        for (const NearEdge& nearOther : nearOthers_) {
            if ((nearOther.low > high || nearOther.high < low).any()) continue;
            const SurfaceTree::Edge& other = at(other_->edges(), nearOther.edge);
            if (!onlyBorders || edge.isBorder() || other.isBorder()) edgeNearEdge(near.edge, nearOther.edge);
        }
    }
}

void NearPairs::edgeNearEdge(int edge, int other) {
    const std::array<int, 2>&ends = at(cloth_->edges(), edge).nodes,
                          &otherEnds = at(other_->edges(), other).nodes;
    const auto isClose = [&](int node) {
        return cloth_->areClose(node, otherEnds[0]) || cloth_->areClose(node, otherEnds[1]);
    };
    if (cloth_ == other_ && (isClose(ends[0]) || isClose(ends[1]))) return;
    const std::optional<NearestOfEdges> nearest = nearestOfEdges(
        at(cloth_->positions(), ends[0]), at(cloth_->positions(), ends[1]),
        at(other_->positions(), otherEnds[0]) + offset_, at(other_->positions(), otherEnds[1]) + offset_);
    if (!nearest) return;
    const float distance = nearest->apart.norm();
    if (distance <= near_.ofEdges) edges_.push_back({edge, other, distance, *nearest});
}

}  // namespace drench
