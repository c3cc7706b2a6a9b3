#include "bullet/small_steps/surface_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bullet/contact/contact_law.h"
#include "bullet/sheet/face_projection.h"
#include "bullet/sheet/rest_shape.h"
#include "bullet/world/vectors.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

Eigen::Vector3f positionOf(const MovingNode& node) {
    return {node.x, node.y, node.z};
}

Eigen::Vector3f toFloat(const btVector3& v) {
    return {float(v.x()), float(v.y()), float(v.z())};
}

btVector3 fromFloat(const Eigen::Vector3f& v) {
    return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())};
}

// Edges keep this share of the distance that nodes keep, so that level layers are carried by their nodes.
constexpr float edgeShare = 0.5f;

// Whether the nearest point of another face lies on an edge or corner of this one.
bool holdsPoint(const SurfaceTree::Face& face, const SurfaceTree::Face& of,
                const Eigen::Vector3f& weights) {
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

}  // namespace

void SurfaceContacts::begin(const std::vector<Sheet>& sheets, double substep, int steps) {
    substep_ = substep;
    smallStep_ = substep / steps;
    stepsLeft_ = steps;
    clothCount_ = pairCount_ = 0;
    for (const Sheet& sheet : sheets) addSheet(sheet);
    for (std::size_t i = 0; i < sheets.size(); ++i)
        if (sheets[i].meetsItself) addPair(i, i);
    // Bullet lists pairs of bodies in the order in which they first met, which is unknown to restored sheets.
    const auto namesOf = [](const auto& pair) {
        const int one = pair.first->getWorldArrayIndex(), two = pair.second->getWorldArrayIndex();
        return std::make_pair(std::min(one, two), std::max(one, two));
    };
    std::sort(met_.begin(), met_.end(),
              [&](const auto& a, const auto& b) { return namesOf(a) < namesOf(b); });
    for (const auto& [one, other] : met_) {
        const std::size_t first = indexOfCloth(*one), second = indexOfCloth(*other);
        addPair(std::min(first, second), std::max(first, second));
    }
    std::size_t nodes = 0;
    for (std::size_t c = 0; c < clothCount_; ++c) {
        cloths_[c].firstIndex = nodes;
        nodes += cloths_[c].tree->nodeCount();
        restartMotion(cloths_[c]);
    }
    nearest_.resize(nodes);
    for (std::size_t p = 0; p < pairCount_; ++p) find(pairs_[p]);
    updateAdhesion();
}

SurfaceContacts::Cloth& SurfaceContacts::newCloth() {
    if (clothCount_ == cloths_.size()) cloths_.emplace_back();
    cloths_[clothCount_].touches = false;
    return cloths_[clothCount_++];
}

void SurfaceContacts::addSheet(const Sheet& sheet) {
    Cloth& cloth = newCloth();
    const auto& bonds = sheet.sheetFriction->adheresToCloth;
    const bool adheres =
        std::any_of(bonds.begin(), bonds.end(), [](const btCollisionObject* to) { return to != nullptr; });
    const auto ofSubstep = btScalar(smallStep_ / substep_);
    cloth.body = sheet.body;
    cloth.sheet = sheet.cloth;
    cloth.sheetFriction = sheet.sheetFriction;
    cloth.guest = nullptr;
    cloth.tree = sheet.tree;
    cloth.memory = sheet.memory;
    cloth.origin = sheet.cloth->startPosition(0) - vectorOf(sheet.cloth->start(0));
    cloth.start = &sheet.cloth->start(0);
    cloth.moved = &sheet.cloth->moved(0);
    cloth.reference = &sheet.cloth->predicted(0);
    cloth.isCarried = &sheet.cloth->isCarried(0);
    cloth.margin = float(sheet.body->getCollisionShape()->getMargin());
    cloth.slack = std::max(cloth.margin, float(sheet.cloth->meanLink() / 4));
    cloth.adhesiveReach = adheres ? float(sheet.sheetFriction->reach()) : 0.0f;
    cloth.growth = float(sheet.cloth->farthestPull() * ofSubstep);
    cloth.meanStep = toFloat(sheet.cloth->meanReach() * ofSubstep);
}

// @return its index
std::size_t SurfaceContacts::addGuest(btSoftBody& body) {
    GuestCloth& guest = guests_[&body];
    const auto ofSubstep = float(smallStep_ / substep_);
    guest.begin(body, ofSubstep);
    Cloth& cloth = newCloth();
    cloth.body = &body;
    cloth.sheet = nullptr;
    cloth.sheetFriction = nullptr;
    cloth.guest = &guest;
    cloth.tree = &guest.tree();
    cloth.memory = &guest.memory;
    cloth.origin = guest.origin();
    cloth.start = guest.start().data();
    cloth.moved = guest.moved().data();
    cloth.reference = guest.movedBefore().data();
    cloth.isCarried = guest.isCarried().data();
    cloth.margin = cloth.slack = float(body.getCollisionShape()->getMargin());
    cloth.adhesiveReach = 0;
    cloth.growth = guest.farthestFromMean() * ofSubstep;
    cloth.meanStep = toFloat(guest.meanReach()) * ofSubstep;
    return clothCount_ - 1;
}

std::size_t SurfaceContacts::indexOfCloth(btSoftBody& body) {
    for (std::size_t c = 0; c < clothCount_; ++c)
        if (cloths_[c].body == &body) return c;
    return addGuest(body);
}

void SurfaceContacts::addPair(std::size_t one, std::size_t other) {
    if (pairCount_ == pairs_.size()) pairs_.emplace_back();
    Pair& pair = pairs_[pairCount_++];
    pair.one = one;
    pair.other = other;
    pair.distance = cloths_[one].margin + cloths_[other].margin;
    pair.friction = float(dryFriction(*cloths_[one].body, *cloths_[other].body));
    pair.contacts.clear();
}

// The box of the displacements tells how far any may be from their middle.
void SurfaceContacts::measureMotion(Cloth& cloth) {
    constexpr float far = std::numeric_limits<float>::infinity();
    Eigen::Array4f low = Eigen::Array4f::Constant(far), high = -low;
    for (std::size_t n = 0; n < cloth.movedAt.size(); ++n) {
        const Eigen::Array4f by = Eigen::Map<const Eigen::Array4f>(&cloth.moved[n].x) -
                                  Eigen::Map<const Eigen::Array4f>(&cloth.movedAt[n].x);
        low = low.min(by);
        high = high.max(by);
    }
    const Eigen::Vector3f mean = ((low + high) / 2).head<3>().matrix();
    const float deviation = ((high - low) / 2).head<3>().matrix().norm();
    cloth.growth = std::max(0.0f, deviation - cloth.deviation);
    cloth.meanStep = mean - cloth.mean;
    cloth.mean = mean;
    cloth.deviation = deviation;
}

void SurfaceContacts::restartMotion(Cloth& cloth) {
    cloth.movedAt.assign(cloth.moved, cloth.moved + cloth.tree->nodeCount());
    cloth.mean.setZero();
    cloth.deviation = 0;
    cloth.isDue = false;
    cloth.tree->follow(cloth.start, cloth.moved);
}

// Whether nodes may be farther apart, after another small step like the last one, than was looked for.
bool SurfaceContacts::isDue(const Pair& pair) const {
    const Cloth &one = cloths_[pair.one], &other = cloths_[pair.other];
    const float deviations = one.deviation + other.deviation + one.growth + other.growth;
    const Eigen::Vector3f between = one.mean - other.mean - pair.between + one.meanStep - other.meanStep;
    return !(pair.used + deviations + between.norm() < pair.slack);
}

void SurfaceContacts::findWhatIsDue() {
    for (std::size_t c = 0; c < clothCount_; ++c) measureMotion(cloths_[c]);
    bool areAny = false;
    for (std::size_t p = 0; p < pairCount_; ++p) {
        if (!isDue(pairs_[p])) continue;
        cloths_[pairs_[p].one].isDue = cloths_[pairs_[p].other].isDue = areAny = true;
    }
    if (!areAny) return;
    remember();
    const auto isOfDue = [&](const Pair& pair) { return cloths_[pair.one].isDue || cloths_[pair.other].isDue; };
    dueAgain_.assign(pairCount_, 0);
    for (std::size_t p = 0; p < pairCount_; ++p) dueAgain_[p] = isOfDue(pairs_[p]);
    for (std::size_t c = 0; c < clothCount_; ++c)
        if (cloths_[c].isDue) restartMotion(cloths_[c]);
    for (std::size_t p = 0; p < pairCount_; ++p) {
        if (!dueAgain_[p]) continue;
        Pair& pair = pairs_[p];
        for (const std::size_t c : {pair.one, pair.other})
            if (cloths_[c].deviation > 0) cloths_[c].tree->follow(cloths_[c].start, cloths_[c].moved);
        find(pair);
    }
    updateAdhesion();
}

void SurfaceContacts::find(Pair& pair) {
    const Cloth &one = cloths_[pair.one], &other = cloths_[pair.other];
    const bool isOneCloth = pair.one == pair.other;
    pair.used = one.deviation + other.deviation;
    pair.between = one.mean - other.mean;
    // For what is left of the substep if it goes on like this; more would have to be looked through at once than again.
    constexpr float more = 1.5f, least = 0.1f;
    const float perStep = one.growth + other.growth + (one.meanStep - other.meanStep).norm();
    const float slack = one.slack + other.slack, wanted = more * perStep * float(stepsLeft_);
    pair.slack = std::max(std::clamp(wanted, least * slack, slack), more * perStep);
    pair.contacts.clear();
    // Nodes that pass each other by several cells in a small step cannot be kept apart in such steps.
    if (!(pair.slack < 3 * slack)) return;
    const float adhesiveReach = std::max(one.adhesiveReach, other.adhesiveReach);
    const float around = pair.slack + pair.used;
    const NearPairs::Distances near = {pair.distance + adhesiveReach + around,
                                       edgeShare * pair.distance + around};
    if (isOneCloth)
        near_.findWithin(*one.tree, near);
    else
        near_.find(*one.tree, *other.tree, toFloat(other.origin - one.origin), near);
    choose(pair, near_.nodes(), false);
    choose(pair, near_.nodesOfOther(), true);
    Contact contact;
    for (const NearEdges& edges : near_.edges())
        if (makeContact(pair, edges, contact)) pair.contacts.push_back(contact);
    if (!pair.contacts.empty()) cloths_[pair.one].touches = cloths_[pair.other].touches = true;
}

// The contacts of a node are with the points of the cloth to which its distance is a local minimum. A point on the
// border of a face is none if another face there has a nearer one: the plane through it would end before the node,
// and stop nodes that slide along. Of several layers on one side only the nearest counts.
void SurfaceContacts::choose(Pair& pair, const std::vector<NearFace>& near, bool isOfOther) {
    const std::vector<SurfaceTree::Face>& faces = cloths_[isOfOther ? pair.one : pair.other].tree->faces();
    const auto faceOf = [&](const NearFace& of) -> const SurfaceTree::Face& {
        return faces[static_cast<std::size_t>(of.face)];
    };
    for (std::size_t first = 0, end = 0; first < near.size(); first = end) {
        const std::size_t chosen = pair.contacts.size();
        while (end < near.size() && near[end].node == near[first].node) ++end;
        // Where cloth is crumpled beyond what its mesh can show, those behind do not count.
        constexpr std::size_t most = 32;
        for (std::size_t i = first; i < std::min(end, first + most); ++i) {
            const auto hasPoint = [&](const NearFace& nearer) {
                return holdsPoint(faceOf(nearer), faceOf(near[i]), near[i].nearest.weights);
            };
            const auto at = [&](std::size_t index) { return near.begin() + static_cast<std::ptrdiff_t>(index); };
            Contact contact;
            if (std::any_of(at(first), at(i), hasPoint) || !makeContact(pair, near[i], isOfOther, contact))
                continue;
            // Another layer, behind a nearer one.
            constexpr float alike = 0.7f, layer = 0.5f;
            const auto isAlike = [&](const Contact& nearer) {
                return nearer.normal.dot(contact.normal) > alike &&
                       contact.gap - nearer.gap > layer * pair.distance;
            };
            const auto firstChosen = pair.contacts.begin() + static_cast<std::ptrdiff_t>(chosen);
            if (std::none_of(firstChosen, pair.contacts.end(), isAlike)) pair.contacts.push_back(contact);
        }
    }
}

void SurfaceContacts::place(Contact& contact, const Cloth& first, const Cloth& second,
                          const std::array<int, 4>& nodes, int ofFirst) const {
    const Eigen::Vector3f between = toFloat(second.origin - first.origin);
    const Eigen::Vector3f origin = positionOf(first.start[nodes[0]]);
    for (int i = 0; i < 4; ++i) {
        const Cloth& cloth = i < ofFirst ? first : second;
        const auto slot = static_cast<std::size_t>(i);
        contact.moved[slot] = &cloth.moved[nodes[slot]];
        contact.reference[slot] = &cloth.reference[nodes[slot]];
        contact.isCarried[slot] = &cloth.isCarried[nodes[slot]];
        if (i == 0) continue;
        contact.offsets[slot - 1] = positionOf(cloth.start[nodes[slot]]) - origin;
        if (i >= ofFirst) contact.offsets[slot - 1] += between;
    }
    contact.findResponse();
    contact.renewedAt = contact.apart();
}

// @return whether the face has an area, and the numbers are finite
bool SurfaceContacts::makeContact(const Pair& pair, const NearFace& near, bool isOfOther,
                                Contact& contact) const {
    const Cloth &ofNode = cloths_[isOfOther ? pair.other : pair.one],
                &ofFace = cloths_[isOfOther ? pair.one : pair.other];
    const SurfaceTree::Face& face = ofFace.tree->faces()[static_cast<std::size_t>(near.face)];
    const Eigen::Vector3f& up = ofFace.tree->normals()[static_cast<std::size_t>(near.face)];
    constexpr float level = 0.99f, inPlane = 1e-5f, alike = 0.7f;
    if (!(up.squaredNorm() > level) || !(near.distance < std::numeric_limits<float>::max())) return false;
    const ContactMemory::Contact* const last = ofNode.memory->ofFace(near.node, *ofFace.body, face.nodes);
    const float side = last ? last->side : 0.0f;
    const bool isFirst = pair.one == pair.other ? near.node > face.nodes[0] : isOfOther;
    Eigen::Vector3f normal = side != 0 ? up * side : normalInPlane(up, isFirst);
    float between = near.distance;
    if (near.distance > inPlane * pair.distance) {
        normal = near.nearest.apart / near.distance;
        if (normal.dot(up) * side < -alike) {
            normal = -normal;
            between = -between;
        }
    }
    contact = Contact();
    contact.node = near.node;
    contact.face = near.face;
    contact.edge = -1;
    contact.isOfOther = isOfOther;
    contact.weights << 1, -near.nearest.weights;
    contact.normal = normal;
    contact.distance = pair.distance;
    contact.gap = between - contact.distance;
    contact.isTilted = !(std::abs(normal.dot(up)) > level);
    contact.side = contact.isTilted ? side : std::copysign(1.0f, normal.dot(up));
    place(contact, ofNode, ofFace, {near.node, face.nodes[0], face.nodes[1], face.nodes[2]}, 1);
    contact.friction = pair.friction;
    if (ofNode.sheetFriction)
        contact.friction *= float(ofNode.sheetFriction->frictionRatio(static_cast<std::size_t>(near.node)));
    if (last) contact.forces = last->forces;
    return true;
}

bool SurfaceContacts::makeContact(const Pair& pair, const NearEdges& near, Contact& contact) const {
    const Cloth &one = cloths_[pair.one], &other = cloths_[pair.other];
    const std::array<int, 2>&ends = one.tree->edges()[static_cast<std::size_t>(near.edge)].nodes,
                            &others = other.tree->edges()[static_cast<std::size_t>(near.other)].nodes;
    constexpr float inPlane = 1e-5f;
    if (!(near.distance > inPlane * pair.distance && near.distance < std::numeric_limits<float>::max()))
        return false;
    const ContactMemory::Contact* const last =
        one.memory->ofEdges(ends[0], ends[1], *other.body, others[0], others[1]);
    const bool isThrough = last && near.nearest.areInside && near.nearest.apart.dot(last->normal) < 0;
    contact = Contact();
    contact.isOfEdges = true;
    contact.isActive = near.nearest.areInside;
    contact.node = ends[0];
    contact.face = near.other;
    contact.edge = near.edge;
    contact.isOfOther = false;
    const float along = near.nearest.along, alongOther = near.nearest.alongOther;
    contact.weights = {1 - along, along, alongOther - 1, -alongOther};
    contact.normal = near.nearest.apart / (isThrough ? -near.distance : near.distance);
    contact.distance = edgeShare * pair.distance;
    contact.gap = (isThrough ? -near.distance : near.distance) - contact.distance;
    place(contact, one, other, {ends[0], ends[1], others[0], others[1]}, 2);
    contact.friction = pair.friction;
    if (one.sheetFriction)
        contact.friction *= float(one.sheetFriction->frictionRatio(static_cast<std::size_t>(ends[0])));
    if (last) contact.forces = last->forces;
    return true;
}

// Wet cloth adheres only by the nearest contact of each node; otherwise adhesion would count several times.
void SurfaceContacts::updateAdhesion() {
    std::fill(nearest_.begin(), nearest_.end(), Nearest{nullptr, nullptr});
    for (std::size_t p = 0; p < pairCount_; ++p) {
        Pair& pair = pairs_[p];
        for (Contact& contact : pair.contacts) {
            const Cloth& cloth = clothOfNode(pair, contact);
            if (contact.isOfEdges || !cloth.sheetFriction || !cloth.sheetFriction->canAdhere()) continue;
            Nearest& nearest = nearest_[cloth.firstIndex + static_cast<std::size_t>(contact.node)];
            if (!nearest.contact || contact.gap < nearest.contact->gap) nearest = {&pair, &contact};
        }
    }
    for (const Nearest& nearest : nearest_)
        if (nearest.contact) updateAdhesion(*nearest.pair, *nearest.contact);
}

void SurfaceContacts::updateAdhesion(const Pair& pair, Contact& contact) const {
    const Cloth &cloth = clothOfNode(pair, contact), &other = clothOfFace(pair, contact);
    const Friction& ofNode = *cloth.sheetFriction;
    const auto node = static_cast<std::size_t>(contact.node);
    double traction = ofNode.adhesionTraction(node);
    if (other.sheetFriction) {
        const SurfaceTree::Face& face = other.tree->faces()[static_cast<std::size_t>(contact.face)];
        double ofOther = 0;
        for (std::size_t corner = 0; corner < 3; ++corner)
            ofOther -= double(contact.weights[static_cast<int>(corner) + 1]) *
                       other.sheetFriction->adhesionTraction(static_cast<std::size_t>(face.nodes[corner]));
        traction = adhesionTractionBetween(traction, ofOther);
    }
    contact.adhesion = float(traction * ofNode.area(node));
    contact.reach = float(ofNode.reach());
    contact.adheres = contact.adhesion > 0 && (contact.gap < 0 || ofNode.adheresToCloth[node] == other.body);
}

void SurfaceContacts::beginStep() {
    const ContactStep step(static_cast<float>(smallStep_));
    for (std::size_t p = 0; p < pairCount_; ++p)
        for (Contact& contact : pairs_[p].contacts) step.separate(contact);
    for (std::size_t p = 0; p < pairCount_; ++p)
        for (Contact& contact : pairs_[p].contacts) step.begin(contact);
    for (std::size_t c = 0; c < clothCount_; ++c)
        if (cloths_[c].guest) cloths_[c].guest->advance();
}

void SurfaceContacts::goOn() {
    const ContactStep step(static_cast<float>(smallStep_));
    for (std::size_t p = 0; p < pairCount_; ++p)
        for (Contact& contact : pairs_[p].contacts) step.goOn(contact);
}

void SurfaceContacts::solve() {
    const ContactStep step(static_cast<float>(smallStep_));
    for (std::size_t p = 0; p < pairCount_; ++p)
        for (Contact& contact : pairs_[p].contacts) step.solve(contact);
}

void SurfaceContacts::endStep() {
    const ContactStep step(static_cast<float>(smallStep_));
    for (std::size_t p = 0; p < pairCount_; ++p)
        for (Contact& contact : pairs_[p].contacts) step.finish(contact);
    if (--stepsLeft_ > 0) findWhatIsDue();
}

void SurfaceContacts::remember() {
    for (std::size_t c = 0; c < clothCount_; ++c) {
        cloths_[c].memory->clear();
        if (!cloths_[c].sheetFriction) continue;
        std::vector<const btCollisionObject*>& bonds = cloths_[c].sheetFriction->adheresToCloth;
        std::fill(bonds.begin(), bonds.end(), nullptr);
    }
    for (std::size_t p = 0; p < pairCount_; ++p)
        for (const Contact& contact : pairs_[p].contacts) remember(pairs_[p], contact);
    for (std::size_t c = 0; c < clothCount_; ++c) cloths_[c].memory->sort();
}

void SurfaceContacts::remember(const Pair& pair, const Contact& contact) {
    const Cloth &cloth = clothOfNode(pair, contact), &other = clothOfFace(pair, contact);
    if (contact.adheres && cloth.sheetFriction)
        cloth.sheetFriction->adheresToCloth[static_cast<std::size_t>(contact.node)] = other.body;
    // Where both are well apart, their positions tell the side.
    constexpr float near = 0.5f;
    if (!contact.isActive || !(contact.gapAt(contact.apart()) < near * contact.distance)) return;
    ContactMemory::Contact kept;
    kept.node = contact.node;
    kept.other = other.body;
    kept.normal = contact.normal;
    kept.side = contact.isTilted ? 0.0f : contact.side;
    kept.forces = contact.forces;
    if (contact.isOfEdges) {
        const std::array<int, 2>& others = other.tree->edges()[static_cast<std::size_t>(contact.face)].nodes;
        kept.otherEnd = cloth.tree->edges()[static_cast<std::size_t>(contact.edge)].nodes[1];
        kept.corners = {others[0], others[1], -1};
    } else {
        kept.otherEnd = -1;
        kept.corners = other.tree->faces()[static_cast<std::size_t>(contact.face)].nodes;
    }
    cloth.memory->add(kept);
}

void SurfaceContacts::finish() {
    remember();
    for (std::size_t p = 0; p < pairCount_; ++p)
        for (const Contact& contact : pairs_[p].contacts) list(pairs_[p], contact);
    for (std::size_t c = 0; c < clothCount_; ++c)
        if (cloths_[c].guest) cloths_[c].guest->finish(*cloths_[c].body, smallStep_);
}

// Tells other code that reads Bullet's lists which nodes and faces touch.
void SurfaceContacts::list(const Pair& pair, const Contact& contact) const {
    const float gap = contact.gapAt(contact.apart());
    if (contact.isOfEdges || !(contact.touched || gap < 0)) return;
    btSoftBody &ofNode = *clothOfNode(pair, contact).body, &ofFace = *clothOfFace(pair, contact).body;
    const SurfaceTree::Face& found =
        clothOfFace(pair, contact).tree->faces()[static_cast<std::size_t>(contact.face)];
    btSoftBody::Face& face = ofFace.m_faces[found.index];
    btVector3 weights;
    for (int corner = 0; corner < 3; ++corner) {
        const int node = indexOf(ofFace, face.m_n[corner]);
        const auto at = std::find(found.nodes.begin(), found.nodes.end(), node) - found.nodes.begin();
        weights[corner] = -btScalar(contact.weights[static_cast<int>(at) + 1]);
    }
    ofNode.m_scontacts.push_back(silentContact(
        ofNode.m_nodes[contact.node], face, weights, fromFloat(contact.normal),
        btScalar(contact.distance + std::min(gap, 0.0f)), btScalar(contact.friction)));
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
