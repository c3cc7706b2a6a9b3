#include "bullet/small_steps/surface_contacts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "bullet/contact/contact_law.h"
#include "bullet/sheet/face_projection.h"
#include "bullet/sheet/rest_shape.h"
#include "bullet/world/vectors.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// @param factor  from a velocity, or the displacement in a substep, to that in a small step
void setSteps(MeetingCloth& cloth, const MovingNode* motion, std::size_t count, float factor) {
    cloth.steps.resize(count);
    for (std::size_t n = 0; n < count; ++n)
        cloth.steps[n] = {motion[n].x * factor, motion[n].y * factor, motion[n].z * factor, 0};
}

}  // namespace

void SurfaceContacts::begin(const std::vector<Sheet>& sheets, double substep, int steps) {
    substep_ = substep;
    smallStep_ = substep / steps;
    stepsLeft_ = steps;
    clothCount_ = pairCount_ = 0;
    canAdhere_ = false;
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
    forgetOtherGuests();
    std::size_t nodes = 0;
    for (std::size_t c = 0; c < clothCount_; ++c) {
        cloths_[c].firstIndex = nodes;
        nodes += cloths_[c].tree->nodeCount();
    }
    for (std::size_t p = 0; p < pairCount_; ++p)
        for (const std::size_t c : {pairs_[p].one, pairs_[p].other}) cloths_[c].isMet = true;
    for (std::size_t c = 0; c < clothCount_; ++c)
        if (cloths_[c].isMet) cloths_[c].startMotion(steps);
    nearest_.resize(nodes);
    findTangles();
    for (std::size_t p = 0; p < pairCount_; ++p)
        find(pairs_[p], *cloths_[pairs_[p].one].memory, *cloths_[pairs_[p].other].memory);
    updateAdhesion();
    fillBlocks();
}

void SurfaceContacts::findTangles() {
    untangler_.clear();
    for (std::size_t p = 0; p < pairCount_; ++p) {
        MeetingCloth &one = cloths_[pairs_[p].one], &other = cloths_[pairs_[p].other];
        if (untangler_.find(pairs_[p], one, other)) one.crosses = other.crosses = true;
    }
    for (std::size_t c = 0; c < clothCount_; ++c)
        cloths_[c].memory->noteCrossing(cloths_[c].crosses, substep_);
}

MeetingCloth& SurfaceContacts::newCloth() {
    if (clothCount_ == cloths_.size()) cloths_.emplace_back();
    MeetingCloth& cloth = cloths_[clothCount_++];
    cloth.touches = cloth.hasTouchedOthers = cloth.isMet = cloth.crosses = false;
    return cloth;
}

void SurfaceContacts::addSheet(const Sheet& sheet) {
    MeetingCloth& cloth = newCloth();
    const auto& bonds = sheet.sheetFriction->adheresToCloth;
    const bool adheres =
        std::any_of(bonds.begin(), bonds.end(), [](const btCollisionObject* to) { return to != nullptr; });
    cloth.body = sheet.body;
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
    cloth.cell = std::max(cloth.margin, float(sheet.cloth->meanLink() / 4));
    setSteps(cloth, &sheet.cloth->velocity(0), sheet.cloth->size(), float(smallStep_));
    canAdhere_ = canAdhere_ || adheres || sheet.sheetFriction->canAdhere();
    cloth.adhesiveReach = adheres ? float(sheet.sheetFriction->reach()) : 0.0f;
}

// @return its index
std::size_t SurfaceContacts::addGuest(btSoftBody& body) {
    GuestCloth& guest = guests_[&body];
    const auto ofSubstep = float(smallStep_ / substep_);
    guest.begin(body, ofSubstep);
    MeetingCloth& cloth = newCloth();
    cloth.body = &body;
    cloth.sheetFriction = nullptr;
    cloth.guest = &guest;
    cloth.tree = &guest.tree();
    cloth.memory = &guest.memory;
    cloth.origin = guest.origin();
    cloth.start = guest.start().data();
    cloth.moved = guest.moved().data();
    cloth.reference = guest.movedBefore().data();
    cloth.isCarried = guest.isCarried().data();
    cloth.margin = cloth.cell = float(body.getCollisionShape()->getMargin());
    setSteps(cloth, guest.own().data(), guest.own().size(), ofSubstep);
    cloth.adhesiveReach = 0;
    return clothCount_ - 1;
}

// Of those that are not near a sheet in this substep.
void SurfaceContacts::forgetOtherGuests() {
    const auto first = cloths_.begin(), end = first + static_cast<std::ptrdiff_t>(clothCount_);
    for (auto guest = guests_.begin(); guest != guests_.end();) {
        const auto isOf = [&](const MeetingCloth& cloth) { return cloth.guest == &guest->second; };
        guest = std::none_of(first, end, isOf) ? guests_.erase(guest) : std::next(guest);
    }
}

std::size_t SurfaceContacts::indexOfCloth(btSoftBody& body) {
    for (std::size_t c = 0; c < clothCount_; ++c)
        if (cloths_[c].body == &body) return c;
    return addGuest(body);
}

void SurfaceContacts::addPair(std::size_t one, std::size_t other) {
    if (pairCount_ == pairs_.size()) pairs_.emplace_back();
    ClothPair& pair = pairs_[pairCount_++];
    pair.one = one;
    pair.other = other;
    pair.distance = cloths_[one].margin + cloths_[other].margin;
    pair.friction = float(dryFriction(*cloths_[one].body, *cloths_[other].body));
    pair.contacts.clear();
}

void SurfaceContacts::findWhatIsDue() {
    bool areAny = false;
    for (std::size_t c = 0; c < clothCount_; ++c) {
        MeetingCloth& cloth = cloths_[c];
        cloth.isOffItsWay = cloth.isMet && !cloth.isOnItsWay();
        if (cloth.isOffItsWay) cloth.expectMotion();
        areAny = areAny || cloth.isOffItsWay;
    }
    if (!areAny) return;
    blocks_.readBack();
    rememberBonds();
    for (std::size_t p = 0; p < pairCount_; ++p)
        if (cloths_[pairs_[p].one].isOffItsWay || cloths_[pairs_[p].other].isOffItsWay) findAgain(pairs_[p]);
    updateAdhesion();
    fillBlocks();
}

void SurfaceContacts::fillBlocks() {
    blocks_.clear(float(smallStep_));
    groupsOf_.clear();
    for (std::size_t p = 0; p < pairCount_; ++p) addToBlocks(pairs_[p]);
}

// A pair has up to three groups: of its nodes with faces of the other, the other way round, and of edges.
void SurfaceContacts::addToBlocks(ClothPair& pair) {
    for (std::size_t from = 0, end = 0; from < pair.contacts.size(); from = end) {
        const PairContact& first = pair.contacts[from];
        const auto isAlike = [&](const PairContact& contact) {
            return contact.isOfEdges == first.isOfEdges && contact.isOfOther == first.isOfOther;
        };
        ofGroup_.clear();
        while (end < pair.contacts.size() && isAlike(pair.contacts[end]))
            ofGroup_.push_back(&pair.contacts[end++]);
        const MeetingCloth &one = clothOfNode(pair, first), &other = clothOfFace(pair, first);
        blocks_.add({{one.moved, other.moved},
                     {one.reference, other.reference},
                     {one.isCarried, other.isCarried},
                     {one.tree->nodeCount(), other.tree->nodeCount()}},
                    ofGroup_);
        groupsOf_.push_back(&pair);
    }
}

void SurfaceContacts::findAgain(ClothPair& pair) {
    memory_.clear();
    memoryOfOther_.clear();
    for (const PairContact& contact : pair.contacts)
        remember(pair, contact, contact.isOfOther ? memoryOfOther_ : memory_);
    memory_.sort();
    memoryOfOther_.sort();
    cloths_[pair.one].followNodes();
    cloths_[pair.other].followNodes();
    find(pair, memory_, memoryOfOther_);
}

void SurfaceContacts::find(ClothPair& pair, const ContactMemory& memory, const ContactMemory& memoryOfOther) {
    const MeetingCloth &one = cloths_[pair.one], &other = cloths_[pair.other];
    // What passes by several cells in a substep cannot be kept apart.
    constexpr float passing = 3;
    search_.find(pair, one, other, passing * (one.cell + other.cell), memory, memoryOfOther);
    untangler_.leaveOut(pair, one, other);
}

// Wet cloth adheres only by the nearest contact of each node; otherwise adhesion would count several times.
void SurfaceContacts::updateAdhesion() {
    if (!canAdhere_) return;
    std::fill(nearest_.begin(), nearest_.end(), Nearest{nullptr, nullptr});
    for (std::size_t p = 0; p < pairCount_; ++p) {
        ClothPair& pair = pairs_[p];
        for (PairContact& contact : pair.contacts) {
            contact.adhesion = 0;
            const MeetingCloth& cloth = clothOfNode(pair, contact);
            if (contact.isOfEdges || !cloth.sheetFriction || !cloth.sheetFriction->canAdhere()) continue;
            Nearest& nearest = nearest_[cloth.firstIndex + static_cast<std::size_t>(contact.node)];
            if (!nearest.contact || contact.gap < nearest.contact->gap) nearest = {&pair, &contact};
        }
    }
    for (const Nearest& nearest : nearest_)
        if (nearest.contact) updateAdhesion(*nearest.pair, *nearest.contact);
}

void SurfaceContacts::updateAdhesion(const ClothPair& pair, PairContact& contact) const {
    const MeetingCloth &cloth = clothOfNode(pair, contact), &other = clothOfFace(pair, contact);
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
    for (std::size_t c = 0; c < clothCount_; ++c) cloths_[c].touches = false;
    untangler_.pull(smallStep_);
    blocks_.beginStep();
    for (std::size_t c = 0; c < clothCount_; ++c)
        if (cloths_[c].guest) cloths_[c].guest->advance();
}

void SurfaceContacts::goOn() {
    blocks_.goOn();
    notePushes();
}

void SurfaceContacts::notePushes() {
    for (std::size_t group = 0; group < groupsOf_.size(); ++group) {
        const ClothPair& pair = *groupsOf_[group];
        if (blocks_.isPushing(group)) cloths_[pair.one].touches = cloths_[pair.other].touches = true;
    }
}

float SurfaceContacts::solve(bool backwards) {
    const float most = blocks_.solve(backwards);
    notePushes();
    return most;
}

void SurfaceContacts::endStep() {
    blocks_.endStep();
    noteTouches();
    if (--stepsLeft_ > 0) findWhatIsDue();
}

void SurfaceContacts::noteTouches() {
    for (std::size_t group = 0; group < groupsOf_.size(); ++group) {
        const ClothPair& pair = *groupsOf_[group];
        if (pair.one != pair.other && blocks_.hasTouched(group))
            cloths_[pair.one].hasTouchedOthers = cloths_[pair.other].hasTouchedOthers = true;
    }
}

void SurfaceContacts::remember() {
    rememberBonds();
    for (std::size_t c = 0; c < clothCount_; ++c) cloths_[c].memory->clear();
    for (std::size_t p = 0; p < pairCount_; ++p)
        for (const PairContact& contact : pairs_[p].contacts)
            remember(pairs_[p], contact, *clothOfNode(pairs_[p], contact).memory);
    for (std::size_t c = 0; c < clothCount_; ++c) cloths_[c].memory->sort();
}

void SurfaceContacts::rememberBonds() {
    for (std::size_t c = 0; c < clothCount_; ++c) {
        if (!cloths_[c].sheetFriction) continue;
        std::vector<const btCollisionObject*>& bonds = cloths_[c].sheetFriction->adheresToCloth;
        std::fill(bonds.begin(), bonds.end(), nullptr);
    }
    if (!canAdhere_) return;
    for (std::size_t p = 0; p < pairCount_; ++p)
        for (const PairContact& contact : pairs_[p].contacts) {
            const MeetingCloth &cloth = clothOfNode(pairs_[p], contact),
                               &other = clothOfFace(pairs_[p], contact);
            if (contact.adheres && cloth.sheetFriction)
                cloth.sheetFriction->adheresToCloth[static_cast<std::size_t>(contact.node)] = other.body;
        }
}

void SurfaceContacts::remember(const ClothPair& pair, const PairContact& contact, ContactMemory& to) const {
    const MeetingCloth &cloth = clothOfNode(pair, contact), &other = clothOfFace(pair, contact);
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
    to.add(kept);
}

void SurfaceContacts::finish() {
    blocks_.readBack();
    remember();
    for (std::size_t p = 0; p < pairCount_; ++p)
        for (const PairContact& contact : pairs_[p].contacts) list(pairs_[p], contact);
    for (std::size_t c = 0; c < clothCount_; ++c)
        if (cloths_[c].guest) cloths_[c].guest->finish(*cloths_[c].body, smallStep_);
}

// Layers at rest may open by a little from one small step to the next.
bool SurfaceContacts::isActing(const PairContact& contact) {
    constexpr float near = 0.1f;
    const bool isPushed = contact.touched || contact.forces.push > 0;
    return contact.isActive && (isPushed || contact.gapAt(contact.apart()) < near * contact.distance);
}

SurfaceContacts::Acting SurfaceContacts::acting(const ClothPair& pair, const PairContact& contact) const {
    const MeetingCloth &cloth = clothOfNode(pair, contact), &other = clothOfFace(pair, contact);
    Acting acting{cloth.body,     other.body, contact.isOfEdges ? 2 : 1,          {}, {},
                  contact.normal, 0,          std::max(contact.forces.push, 0.0f)};
    if (contact.isOfEdges) {
        const std::array<int, 2>&ends = cloth.tree->edges()[static_cast<std::size_t>(contact.edge)].nodes,
                              &others = other.tree->edges()[static_cast<std::size_t>(contact.face)].nodes;
        acting.nodes = {ends[0], ends[1], others[0], others[1]};
    } else {
        const std::array<int, 3>& corners = other.tree->faces()[static_cast<std::size_t>(contact.face)].nodes;
        acting.nodes = {contact.node, corners[0], corners[1], corners[2]};
        const auto node = static_cast<std::size_t>(contact.node);
        acting.area = cloth.sheetFriction ? float(cloth.sheetFriction->area(node))
                                          : float(cloth.body->m_nodes[contact.node].m_area);
    }
    // The nearest point of a plane that turned may be beyond its face.
    float ofFirst = 0, ofSecond = 0;
    for (int corner = 0; corner < 4; ++corner) {
        const bool isFirst = corner < acting.ofFirst;
        const float weight = std::max(contact.weights[corner] * (isFirst ? 1.0f : -1.0f), 0.0f);
        acting.weights[static_cast<std::size_t>(corner)] = weight;
        (isFirst ? ofFirst : ofSecond) += weight;
    }
    for (int corner = 0; corner < 4; ++corner)
        acting.weights[static_cast<std::size_t>(corner)] /= corner < acting.ofFirst ? ofFirst : ofSecond;
    return acting;
}

// Tells other code that reads Bullet's lists which nodes and faces touch.
void SurfaceContacts::list(const ClothPair& pair, const PairContact& contact) const {
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
    ofNode.m_scontacts.push_back(
        silentContact(ofNode.m_nodes[contact.node], face, weights, fromFloat(contact.normal),
                      btScalar(contact.distance + std::min(gap, 0.0f)), btScalar(contact.friction)));
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
