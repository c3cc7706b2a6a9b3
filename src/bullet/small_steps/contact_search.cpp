#include "bullet/small_steps/contact_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bullet/world/vectors.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

Eigen::Vector3f positionOf(const MovingNode& node) {
    return {node.x, node.y, node.z};
}

// Edges keep this share of the distance that nodes keep, so that level layers are carried by their nodes.
constexpr float edgeShare = 0.5f;

// Whether the nearest point of another face lies on an edge or corner of this one.
bool holdsPoint(const SurfaceTree::Face& face, const SurfaceTree::Face& of, const Eigen::Vector3f& weights) {
    constexpr float none = 1e-4f;
    for (std::size_t corner = 0; corner < 3; ++corner)
        if (weights[static_cast<int>(corner)] > none &&
            std::find(face.nodes.begin(), face.nodes.end(), of.nodes[corner]) == face.nodes.end())
            return false;
    return true;
}

// Of two faces that lie in one plane, or of a node in a face, which touch for the first time, either must be on the
// other side for the other, so that they move apart.
Eigen::Vector3f normalInPlane(const Eigen::Vector3f& normal, bool isFirst) {
    const Eigen::Vector3f anyDirection(0.31f, 0.91f, 0.27f);
    return (normal.dot(anyDirection) > 0) == isFirst ? normal : -normal;
}

// @param ofFirst  number of nodes that are of the first cloth
void place(PairContact& contact, const MeetingCloth& first, const MeetingCloth& second,
           const std::array<int, 4>& nodes, int ofFirst) {
    const Eigen::Vector3f between = toFloat(second.origin - first.origin);
    const Eigen::Vector3f origin = positionOf(first.start[nodes[0]]);
    for (int i = 0; i < 4; ++i) {
        const MeetingCloth& cloth = i < ofFirst ? first : second;
        const auto slot = static_cast<std::size_t>(i);
        contact.nodes[slot] = nodes[slot];
        contact.moved[slot] = &cloth.moved[nodes[slot]];
        if (i == 0) continue;
        contact.offsets[slot - 1] = positionOf(cloth.start[nodes[slot]]) - origin;
        if (i >= ofFirst) contact.offsets[slot - 1] += between;
    }
    contact.slipWeights = contact.weights;
    contact.renewedAt = contact.apart();
    contact.findResponses();
}

}  // namespace

void ContactSearch::find(ClothPair& pair, const MeetingCloth& one, const MeetingCloth& other, float farthest,
                         const ContactMemory& memory, const ContactMemory& memoryOfOther) {
    pair_ = &pair;
    one_ = &one;
    other_ = &other;
    memory_ = &memory;
    memoryOfOther_ = &memoryOfOther;
    const NearPairs::Distances near = {pair.distance, edgeShare * pair.distance, farthest};
    if (&one == &other)
        near_.findWithin(*one.tree, near);
    else
        near_.find(*one.tree, *other.tree, toFloat(other.origin - one.origin), near);
    findBonds(false);
    if (&one != &other) findBonds(true);
    pair.contacts.clear();
    choose(near_.nodes(), false);
    choose(near_.nodesOfOther(), true);
    PairContact contact;
    for (const NearEdges& edges : near_.edges())
        if (makeContact(edges, contact)) pair.contacts.push_back(contact);
}

// A bond may be longer than what comes near is away.
void ContactSearch::findBonds(bool areOfOther) {
    const MeetingCloth &ofNodes = areOfOther ? *other_ : *one_, &ofFaces = areOfOther ? *one_ : *other_;
    if (!(ofNodes.adhesiveReach > 0)) return;
    const std::vector<const btCollisionObject*>& bonds = ofNodes.sheetFriction->adheresToCloth;
    bonded_.clear();
    for (std::size_t n = 0; n < bonds.size(); ++n)
        if (bonds[n] == ofFaces.body) bonded_.push_back(static_cast<int>(n));
    near_.addNearest(bonded_, areOfOther, pair_->distance + ofNodes.adhesiveReach);
}

// The contacts of a node are with the points of the cloth to which its distance is a local minimum. A point on the
// border of a face is none if another face there has a nearer one: the plane through it would end before the node,
// and stop nodes that slide along. Of several layers on one side only the nearest counts.
void ContactSearch::choose(const std::vector<NearFace>& near, bool isOfOther) {
    const std::vector<SurfaceTree::Face>& faces = (isOfOther ? one_ : other_)->tree->faces();
    const auto faceOf = [&](const NearFace& of) -> const SurfaceTree::Face& {
        return faces[static_cast<std::size_t>(of.face)];
    };
    for (std::size_t first = 0, end = 0; first < near.size(); first = end) {
        const std::size_t chosen = pair_->contacts.size();
        while (end < near.size() && near[end].node == near[first].node) ++end;
        // Where cloth is crumpled beyond what its mesh can show, those behind do not count.
        constexpr std::size_t most = 32;
        for (std::size_t i = first; i < std::min(end, first + most); ++i) {
            const auto hasPoint = [&](const NearFace& nearer) {
                return holdsPoint(faceOf(nearer), faceOf(near[i]), near[i].nearest.weights);
            };
            const auto at = [&](std::size_t index) {
                return near.begin() + static_cast<std::ptrdiff_t>(index);
            };
            PairContact contact;
            if (std::any_of(at(first), at(i), hasPoint) || !makeContact(near[i], isOfOther, contact))
                continue;
            // Another layer, behind a nearer one.
            constexpr float alike = 0.7f, layer = 0.5f;
            const auto isAlike = [&](const PairContact& nearer) {
                return nearer.normal.dot(contact.normal) > alike &&
                       contact.gap - nearer.gap > layer * pair_->distance;
            };
            const auto firstChosen = pair_->contacts.begin() + static_cast<std::ptrdiff_t>(chosen);
            if (std::none_of(firstChosen, pair_->contacts.end(), isAlike)) pair_->contacts.push_back(contact);
        }
        passOnForces(near[first].node, isOfOther, chosen);
    }
}

// The force of a contact goes to one contact that takes its place: with the same face, or else with the nearest that is
// adjacent. If each adjacent one had it, a node that comes over an edge would be thrown.
// @param chosen  index of the first contact of the node
void ContactSearch::passOnForces(int node, bool isOfOther, std::size_t chosen) {
    const MeetingCloth& ofFace = *(isOfOther ? one_ : other_);
    const auto cornersOf = [&](const PairContact& contact) -> const std::array<int, 3>& {
        return ofFace.tree->faces()[static_cast<std::size_t>(contact.face)].nodes;
    };
    const auto end = pair_->contacts.end(),
               first = end - static_cast<std::ptrdiff_t>(pair_->contacts.size() - chosen);
    (isOfOther ? memoryOfOther_ : memory_)
        ->forFacesOf(node, *ofFace.body, [&](const ContactMemory::Contact& last) {
            auto heir = std::find_if(
                first, end, [&](const PairContact& contact) { return cornersOf(contact) == last.corners; });
            if (heir == end)
                heir = std::find_if(first, end, [&](const PairContact& contact) {
                    return ContactMemory::shareNode(cornersOf(contact), last.corners);
                });
            if (heir == end) return;
            heir->forces.push += last.forces.push * std::max(heir->normal.dot(last.normal), 0.0f);
            heir->forces.drag += last.forces.drag;
        });
}

// @return whether the face has an area, and the numbers are finite
bool ContactSearch::makeContact(const NearFace& near, bool isOfOther, PairContact& contact) const {
    const MeetingCloth &ofNode = *(isOfOther ? other_ : one_), &ofFace = *(isOfOther ? one_ : other_);
    const SurfaceTree::Face& face = ofFace.tree->faces()[static_cast<std::size_t>(near.face)];
    const Eigen::Vector3f& up = ofFace.tree->normals()[static_cast<std::size_t>(near.face)];
    constexpr float level = 0.99f, inPlane = 1e-5f, alike = 0.7f;
    if (!(up.squaredNorm() > level) || !(near.distance < std::numeric_limits<float>::max())) return false;
    const ContactMemory::Contact* const last =
        (isOfOther ? memoryOfOther_ : memory_)->ofFace(near.node, *ofFace.body, face.nodes);
    const float side = last ? last->side : 0.0f;
    const bool isFirst = one_ == other_ ? near.node > face.nodes[0] : isOfOther;
    Eigen::Vector3f normal = side != 0 ? up * side : normalInPlane(up, isFirst);
    float between = near.distance;
    if (near.distance > inPlane * pair_->distance) {
        normal = near.nearest.apart / near.distance;
        if (normal.dot(up) * side < -alike) {
            normal = -normal;
            between = -between;
        }
    }
    contact = PairContact();
    contact.node = near.node;
    contact.face = near.face;
    contact.edge = -1;
    contact.isOfOther = isOfOther;
    contact.weights << 1, -near.nearest.weights;
    contact.normal = normal;
    contact.distance = pair_->distance;
    contact.gap = between - contact.distance;
    contact.isTilted = !(std::abs(normal.dot(up)) > level);
    contact.side = contact.isTilted ? side : std::copysign(1.0f, normal.dot(up));
    place(contact, ofNode, ofFace, {near.node, face.nodes[0], face.nodes[1], face.nodes[2]}, 1);
    contact.friction = pair_->friction;
    if (ofNode.sheetFriction)
        contact.friction *= float(ofNode.sheetFriction->frictionRatio(static_cast<std::size_t>(near.node)));
    return true;
}

bool ContactSearch::makeContact(const NearEdges& near, PairContact& contact) const {
    const MeetingCloth &one = *one_, &other = *other_;
    const std::array<int, 2>&ends = one.tree->edges()[static_cast<std::size_t>(near.edge)].nodes,
                          &others = other.tree->edges()[static_cast<std::size_t>(near.other)].nodes;
    constexpr float inPlane = 1e-5f;
    if (!(near.distance > inPlane * pair_->distance && near.distance < std::numeric_limits<float>::max()))
        return false;
    const ContactMemory::Contact* const last =
        memory_->ofEdges(ends[0], ends[1], *other.body, others[0], others[1]);
    const bool isThrough = last && near.nearest.areInside && near.nearest.apart.dot(last->normal) < 0;
    contact = PairContact();
    contact.isOfEdges = true;
    contact.isActive = near.nearest.areInside;
    contact.node = ends[0];
    contact.face = near.other;
    contact.edge = near.edge;
    contact.isOfOther = false;
    const float along = near.nearest.along, alongOther = near.nearest.alongOther;
    contact.weights = {1 - along, along, alongOther - 1, -alongOther};
    contact.normal = near.nearest.apart / (isThrough ? -near.distance : near.distance);
    contact.distance = edgeShare * pair_->distance;
    contact.gap = (isThrough ? -near.distance : near.distance) - contact.distance;
    place(contact, one, other, {ends[0], ends[1], others[0], others[1]}, 2);
    contact.friction = pair_->friction;
    if (one.sheetFriction)
        contact.friction *= float(one.sheetFriction->frictionRatio(static_cast<std::size_t>(ends[0])));
    if (last) contact.forces = last->forces;
    return true;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
