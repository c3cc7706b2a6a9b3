#include "bullet/small_steps/soft_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bullet/contact/contact_law.h"
#include "bullet/contact/flat_neighbours.h"
#include "bullet/sheet/rest_shape.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

bool shareNode(const btSoftBody::Face& one, const btSoftBody::Face& other) {
    for (const btSoftBody::Node* node : one.m_n)
        if (std::find(other.m_n, other.m_n + 3, node) != other.m_n + 3) return true;
    return false;
}

btVector3 normalOf(const btSoftBody::Face& face) {
    const btVector3& origin = face.m_n[0]->m_x;
    return (face.m_n[1]->m_x - origin).cross(face.m_n[2]->m_x - origin);
}

// On which side of a face a node exactly in its plane counts if it has not touched the face before: nodes of
// either sheet must get opposite sides, so that the sheets move apart.
btVector3 sideInPlane(const btVector3& normal, const btSoftBody& owner, const btSoftBody& other) {
    const btVector3 anyDirection(btScalar(0.31), btScalar(0.91), btScalar(0.27));
    const bool isAlong = normal.dot(anyDirection) > 0;
    return isAlong == (owner.getWorldArrayIndex() > other.getWorldArrayIndex()) ? normal : -normal;
}

// Neighbours may pull a node farther than it would move by itself.
btScalar pulled(const SmallStepSheet& cloth) {
    return cloth.farthestPull();
}

btDbvtVolume swept(const btVector3& from, const btVector3& to, btScalar around) {
    Bounds bounds = {from, from};
    bounds.take(to);
    bounds.grow(around);
    return btDbvtVolume::FromMM(bounds.low, bounds.high);
}

// Contacts that Bullet does not resolve are those of this library; their normals point to the node.
bool isSilent(const btSoftBody::SContact& contact) {
    return contact.m_cfm[0] == 0 && contact.m_cfm[1] == 0;
}

}  // namespace

// Searches the faces near a node.
struct SoftContacts::Finder final : btDbvt::ICollide {
    Finder(SoftContacts& contacts, const btSoftBody& owner, const btSoftBody& other, btScalar margins)
        : contacts_(contacts),
          owner_(owner),
          other_(other),
          margin_(margins),
          friction_(dryFriction(owner, other)),
          remembered_(contacts.bodyOf(owner).remembered) {}

    // Adds the contacts of a node that count. Called in the order of the nodes.
    void find(btSoftBody::Node& node, const btDbvtVolume& around) {
        const btDbvt& tree = other_.m_fdbvt;
        node_ = &node;
        near_.clear();
        tree.collideTVNoStackAlloc(tree.m_root, around, stack_, *this);
        if (near_.empty()) return;
        beginLast();
        choose();
    }

    void Process(const btDbvtNode* leaf) override {
        auto& face = *static_cast<btSoftBody::Face*>(leaf->data);
        const FaceProjection::Nearest nearest =
            projection_.of(node_->m_x, face.m_n[0]->m_x, face.m_n[1]->m_x, face.m_n[2]->m_x);
        near_.push_back({&face, nearest, nearest.apart.length()});
    }

  private:
    // The contacts of a node are with the points of the cloth to which its distance is a local minimum. A point
    // on the border of a face is none if another face there has a nearer one: the plane through it would end
    // before the node, and stop nodes that slide along. Local minima change continuously when the node moves;
    // the nearest point alone would jump.
    void choose() {
        std::sort(near_.begin(), near_.end(), [](const Near& a, const Near& b) {
            return a.distance != b.distance ? a.distance < b.distance : a.face < b.face;
        });
        for (std::size_t i = 0; i < near_.size(); ++i) {
            Found found;
            const auto hasPoint = [&](const Near& nearer) { return holdsPoint(*nearer.face, near_[i]); };
            const auto end = near_.begin() + static_cast<std::ptrdiff_t>(i);
            if (std::none_of(near_.begin(), end, hasPoint) && decideSide(near_[i], found))
                contacts_.found_.push_back(found);
        }
    }

    // Whether the nearest point of another face lies on an edge or corner of this one.
    static bool holdsPoint(const btSoftBody::Face& face, const Near& near) {
        constexpr auto none = btScalar(1e-4);
        for (int corner = 0; corner < 3; ++corner)
            if (near.nearest.weights[corner] > none &&
                std::find(face.m_n, face.m_n + 3, near.face->m_n[corner]) == face.m_n + 3)
                return false;
        return true;
    }

    // @return whether the face has an area, and the numbers are finite
    bool decideSide(const Near& near, Found& found) const {
        const btSoftBody::Face& face = *near.face;
        btVector3 up = normalOf(face);
        const btScalar area = up.length();
        if (!(area > 0 && near.distance < std::numeric_limits<btScalar>::max())) return false;
        up /= area;
        const Remembered* const last = lastContact(face);
        const btScalar side = last ? up.dot(last->normal) : btScalar(0);
        // The last contact with the border of the cloth says nothing about sides.
        constexpr auto sure = btScalar(0.3);
        const bool knowsSide = std::abs(side) > sure;
        if (side < 0) up = -up;
        constexpr auto inPlane = btScalar(1e-5);
        btVector3 normal = knowsSide ? up : sideInPlane(up, owner_, other_);
        if (near.distance > inPlane * margin_) {
            normal = near.nearest.apart / near.distance;
            if (knowsSide && faceAlike(normal, -up)) normal = -normal;
        }
        found.contact = silentContact(*node_, *near.face, near.nearest.weights, normal, margin_, friction_);
        constexpr auto level = btScalar(0.99);
        found.isTilted = !(std::abs(normal.dot(up)) > level);
        found.side = knowsSide ? (side < 0 ? btScalar(-1) : btScalar(1)) : btScalar(0);
        found.pressed = last ? std::clamp(margin_ - last->kept, btScalar(0), margin_ / 2) : btScalar(0);
        return true;
    }

    // Finds the last contacts of the node with the other body.
    void beginLast() {
        const btSoftBody::Face *const first = &other_.m_faces[0], *const end = first + other_.m_faces.size();
        const auto isBefore = [this](const Remembered& each, const btSoftBody::Face* face) {
            return each.node != node_ ? each.node < node_ : each.face < face;
        };
        firstLast_ = std::lower_bound(remembered_.begin(), remembered_.end(), first, isBefore);
        endLast_ = std::lower_bound(firstLast_, remembered_.end(), end, isBefore);
    }

    // The last contact of the node with a face or with one that shares a node with it; null for none.
    const Remembered* lastContact(const btSoftBody::Face& face) const {
        const Remembered* adjacent = nullptr;
        for (auto each = firstLast_; each != endLast_; ++each) {
            if (each->face == &face) return &*each;
            if (!adjacent && shareNode(*each->face, face)) adjacent = &*each;
        }
        return adjacent;
    }

    SoftContacts& contacts_;
    const btSoftBody& owner_;
    const btSoftBody& other_;
    const btScalar margin_;
    const btScalar friction_;
    const std::vector<Remembered>& remembered_;
    std::vector<Remembered>::const_iterator firstLast_, endLast_;  // of this node with the other body
    btSoftBody::Node* node_ = nullptr;
    std::vector<Near>& near_ = contacts_.near_;
    btNodeStack& stack_ = contacts_.stack_;
    FaceProjection projection_;
};

void SoftContacts::clear() {
    found_.clear();
    pairs_.clear();
    for (Body& body : bodies_) {
        body.remembered.clear();
        body.sheet = nullptr;
        body.guests.clear();
    }
}

SoftContacts::Body& SoftContacts::bodyOf(const btSoftBody& body) {
    const auto index = static_cast<std::size_t>(std::max(body.getWorldArrayIndex(), 0));
    if (index >= bodies_.size()) bodies_.resize(index + 1);
    return bodies_[index];
}

void SoftContacts::remember(const btSoftBody& body) {
    if (body.m_scontacts.size() == 0) return;
    std::vector<Remembered>& remembered = bodyOf(body).remembered;
    for (int i = 0; i < body.m_scontacts.size(); ++i) {
        const btSoftBody::SContact& contact = body.m_scontacts[i];
        if (isSilent(contact))
            remembered.push_back({contact.m_node, contact.m_face, contact.m_normal, contact.m_margin});
    }
    std::sort(remembered.begin(), remembered.end(), [](const Remembered& a, const Remembered& b) {
        return a.node != b.node ? a.node < b.node : a.face < b.face;
    });
}

void SoftContacts::find(btSoftBody& nodes, btSoftBody& faces, const SmallStepSheet* ofNodes,
                        const Friction* sheetFriction) {
    if (faces.m_fdbvt.empty()) return;
    const std::size_t first = found_.size();
    const btScalar margin = nodes.getCollisionShape()->getMargin(),
                   margins = margin + faces.getCollisionShape()->getMargin();
    Finder finder(*this, nodes, faces, margins);
    for (int n = 0; n < nodes.m_nodes.size(); ++n) {
        btSoftBody::Node& node = nodes.m_nodes[n];
        const auto i = static_cast<std::size_t>(n);
        const btVector3 other = ofNodes ? node.m_x + vectorOf(ofNodes->reach(i)) : node.m_q;
        btScalar around = margin + (ofNodes ? pulled(*ofNodes) : btScalar(0));
        if (ofNodes && sheetFriction->adheresToCloth[i]) around += btScalar(sheetFriction->reach());
        finder.find(node, swept(node.m_x, other, around));
    }
    if (found_.size() > first) pairs_.push_back({&nodes, &faces, first, found_.size(), margins});
}

void SoftContacts::begin(const std::vector<Sheet>& sheets, double substep, int steps) {
    substep_ = btScalar(substep);
    fraction_ = 1 / btScalar(steps);
    isFirstStep_ = true;
    contacts_.clear();
    guests_.clear();
    // Bullet lists pairs of bodies in the order in which they first met, which is unknown to restored sheets.
    std::sort(pairs_.begin(), pairs_.end(), [](const Pair& a, const Pair& b) {
        const int one = a.owner->getWorldArrayIndex(), two = b.owner->getWorldArrayIndex();
        return one != two ? one < two : a.other->getWorldArrayIndex() < b.other->getWorldArrayIndex();
    });
    for (const Sheet& sheet : sheets) bodyOf(*sheet.body).sheet = &sheet;
    for (std::size_t pair = 0; pair < pairs_.size();) {
        const btSoftBody* const owner = pairs_[pair].owner;
        const std::size_t first = contacts_.size();
        for (; pair < pairs_.size() && pairs_[pair].owner == owner; ++pair)
            for (std::size_t found = pairs_[pair].first; found < pairs_[pair].end; ++found)
                contacts_.push_back(placed(pair, found));
        if (const Sheet* const sheet = bodyOf(*owner).sheet) updateAdhesion(*sheet, first, contacts_.size());
    }
    for (Contact& contact : contacts_) separate(contact, float(pairs_[contact.pair].margin));
}

void SoftContacts::updateAdhesion(const Sheet& sheet, std::size_t first, std::size_t end) {
    const Friction& sheetFriction = *sheet.sheetFriction;
    if (!sheetFriction.canAdhere()) return;
    nearest_.assign(sheet.cloth->size(), -1);
    for (std::size_t i = first; i < end; ++i) {
        int& nearest = nearest_[contacts_[i].nodes[0]];
        if (nearest < 0 || contacts_[i].gap < contacts_[static_cast<std::size_t>(nearest)].gap)
            nearest = static_cast<int>(i);
    }
    for (const int nearest : nearest_) {
        if (nearest < 0) continue;
        Contact& contact = contacts_[static_cast<std::size_t>(nearest)];
        const btSoftBody& other = *pairs_[contact.pair].other;
        const Sheet* const ofFace = bodyOf(other).sheet;
        updateAdhesion(contact, other, sheetFriction, ofFace ? ofFace->sheetFriction : nullptr);
    }
}

void SoftContacts::updateAdhesion(Contact& contact, const btSoftBody& other, const Friction& ofNode,
                                  const Friction* ofFace) {
    const std::size_t node = contact.nodes[0];
    double traction = ofNode.adhesionTraction(node);
    if (ofFace) {
        double ofOther = 0;
        for (std::size_t corner = 1; corner < 4; ++corner)
            ofOther -= double(contact.weights[corner]) * ofFace->adhesionTraction(contact.nodes[corner]);
        traction = adhesionTractionBetween(traction, ofOther);
    }
    contact.adhesion = float(traction * ofNode.area(node));
    contact.reach = float(ofNode.reach());
    contact.adheres = contact.adhesion > 0 && (contact.gap < 0 || ofNode.adheresToCloth[node] == &other);
}

SoftContacts::Contact SoftContacts::placed(std::size_t pair, std::size_t found) {
    const btSoftBody::SContact& source = found_[found].contact;
    Contact contact = {};
    contact.pair = pair;
    contact.found = found;
    btVector3 apart = place(contact, 0, *source.m_node, *pairs_[pair].owner);
    contact.weights[0] = 1;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::size_t at = corner + 1;
        const btScalar weight = source.m_weights[int(corner)];
        apart -= place(contact, at, *source.m_face->m_n[corner], *pairs_[pair].other) * weight;
        contact.weights[at] = -float(weight);
    }
    contact.normal = source.m_normal;
    contact.friction = float(source.m_friction);
    if (const Sheet* const sheet = bodyOf(*pairs_[pair].owner).sheet)
        contact.friction *= float(sheet->sheetFriction->frictionRatio(contact.nodes[0]));
    contact.response = responseOf(contact);
    contact.gap = float(apart.dot(source.m_normal) - pairs_[pair].margin);
    contact.isTilted = found_[found].isTilted;
    contact.side = found_[found].side;
    contact.pressed = float(found_[found].pressed);
    return contact;
}

float SoftContacts::depthOf(const Contact& contact) {
    return -(contact.gap + float(apartOf(contact).dot(contact.normal)));
}

// Moves overlapping cloth apart without changing its velocity.
void SoftContacts::separate(Contact& contact, float margin) {
    const float depth = depthOf(contact) - contact.pressed;
    if (!(depth > 0 && contact.response > 0 && depth < std::numeric_limits<float>::max())) return;
    const float apart = liftAtOnce(depth, margin) / contact.response;
    for (std::size_t i = 0; i < 4; ++i) {
        const btVector3 by =
            contact.normal * btScalar(apart * contact.weights[i] * contact.moved[i]->inverseMass);
        if (contact.sheets[i])
            contact.sheets[i]->place(contact.nodes[i], by);
        else
            shift(*contact.moved[i], by);
    }
}

void SoftContacts::allowOverlap() {
    for (Contact& contact : contacts_) {
        contact.allowed = std::max(0.0f, depthOf(contact) - contact.pressed);
        contact.gap += contact.allowed;
        contact.held = contact.renewedAt = apartOf(contact);
        contact.depth = depthOf(contact);
    }
}

btVector3 SoftContacts::place(Contact& contact, std::size_t corner, btSoftBody::Node& node,
                              const btSoftBody& owner) {
    if (const Sheet* const sheet = bodyOf(owner).sheet) {
        contact.sheets[corner] = sheet->cloth;
        contact.nodes[corner] = static_cast<std::size_t>(indexOf(owner, &node));
        contact.moved[corner] = &sheet->cloth->moved(contact.nodes[corner]);
        return sheet->cloth->startPosition(contact.nodes[corner]);
    }
    contact.sheets[corner] = nullptr;
    contact.nodes[corner] = guestOf(node, owner);
    Guest& guest = guests_[contact.nodes[corner]];
    contact.moved[corner] = &guest.moved;
    return guest.start;
}

std::size_t SoftContacts::guestOf(btSoftBody::Node& node, const btSoftBody& owner) {
    std::vector<int>& guests = bodyOf(owner).guests;
    if (guests.empty()) guests.assign(static_cast<std::size_t>(owner.m_nodes.size()), -1);
    int& guest = guests[static_cast<std::size_t>(indexOf(owner, &node))];
    if (guest < 0) {
        guest = static_cast<int>(guests_.size());
        // Bullet does not move sleeping bodies, and neither does this.
        const bool isAwake = owner.isActive();
        const btVector3 start = isAwake ? node.m_q : node.m_x;
        guests_.push_back(
            {&node, start, node.m_x - start, {0, 0, 0, isAwake ? float(node.m_im) : 0}, {0, 0, 0}});
    }
    return static_cast<std::size_t>(guest);
}

void SoftContacts::advance() {
    for (Guest& guest : guests_) {
        // The node continues with the velocity that it got from impulses.
        const btVector3 step = isFirstStep_ ? guest.own * fraction_ : vectorOf(guest.moved) - guest.before;
        guest.before = vectorOf(guest.moved);
        shift(guest.moved, step);
    }
    isFirstStep_ = false;
}

void SoftContacts::solve() {
    for (Contact& contact : contacts_) contact.push = contact.maxDrag = 0;
    constexpr int sweeps = 3;
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (Contact& contact : contacts_) pushApart(contact);
    for (Contact& contact : contacts_) rub(contact);
    for (Contact& contact : contacts_) settle(contact);
    for (Contact& contact : contacts_) {
        if (contact.isTilted) renew(contact);
        contact.depth = depthOf(contact);
    }
}

// A large correction is not to become motion: a face that has pushed in this small step does not move quickly
// away from the node. (Slow motion stays. Cloth that is lifted without velocity falls again, and never rests.)
void SoftContacts::settle(Contact& contact) {
    constexpr float slow = 0.2f;
    const float opened = contact.depth - depthOf(contact) - slow * float(pairs_[contact.pair].margin);
    if (!(contact.push > 0 && opened > 0 && opened < std::numeric_limits<float>::max())) return;
    for (std::size_t i = 0; i < 4; ++i) {
        const btVector3 by = contact.normal * btScalar(opened * contact.weights[i] *
                                                       contact.moved[i]->inverseMass / contact.response);
        if (contact.sheets[i])
            contact.sheets[i]->slow(contact.nodes[i], by);
        else
            guests_[contact.nodes[i]].before += by;
    }
}

btVector3 SoftContacts::positionOf(const Contact& contact, std::size_t corner) const {
    const btVector3 start = contact.sheets[corner]
                                ? contact.sheets[corner]->startPosition(contact.nodes[corner])
                                : guests_[contact.nodes[corner]].start;
    return start + vectorOf(*contact.moved[corner]);
}

// The plane through a point on the border of the cloth has no end. A node far ahead of a border that slides along
// would meet it, and stop the cloth. So the nearest point of the face is found anew when they have moved. (Not in
// each small step: the planes of cloth at rest stay as they are.)
void SoftContacts::renew(Contact& contact) {
    const btVector3 before = apartOf(contact);
    constexpr auto near = btScalar(0.1);
    const btScalar farthest = near * pairs_[contact.pair].margin;
    if (!((before - contact.renewedAt).length2() > farthest * farthest)) return;
    const btVector3 node = positionOf(contact, 0), a = positionOf(contact, 1), b = positionOf(contact, 2),
                    c = positionOf(contact, 3);
    const FaceProjection::Nearest nearest = projection_.of(node, a, b, c);
    const btVector3 up = (b - a).cross(c - a);
    const btScalar distance = nearest.apart.length(), margin = pairs_[contact.pair].margin;
    constexpr auto inPlane = btScalar(1e-5);
    if (!(distance > inPlane * margin && distance < std::numeric_limits<btScalar>::max())) return;
    const btVector3 normal = nearest.apart / distance;
    // Behind the face the node would be deep inside at once, and be thrown.
    if (!(normal.dot(contact.normal) > 0 && normal.dot(up) * contact.side >= 0)) return;
    contact.normal = normal;
    for (int corner = 0; corner < 3; ++corner) contact.weights[corner + 1] = -float(nearest.weights[corner]);
    contact.response = responseOf(contact);
    const btVector3 apart = contact.renewedAt = apartOf(contact);
    contact.held += apart - before;
    contact.gap = float((nearest.apart - apart).dot(normal) - margin) + contact.allowed;
    btSoftBody::SContact& source = found_[contact.found].contact;
    source.m_normal = normal;
    source.m_weights = nearest.weights;
}

float SoftContacts::responseOf(const Contact& contact) {
    float response = 0;
    for (std::size_t i = 0; i < 4; ++i)
        response += contact.weights[i] * contact.weights[i] * contact.moved[i]->inverseMass;
    return response;
}

// In each sweep the push of the small step is corrected as a whole: a contact that a later one has opened takes
// its push back. Otherwise the first of several contacts that could carry a node would carry it alone, and
// throw it.
void SoftContacts::pushApart(Contact& contact) {
    const auto depth = btScalar(depthOf(contact));
    if (!(contact.response > 0 && std::abs(depth) < std::numeric_limits<btScalar>::max())) return;
    contact.adheres = adhesionHolds(contact.adhesion, contact.adheres || depth > 0, -depth, contact.reach);
    if (!(depth > 0 || contact.adheres || contact.push > 0)) return;
    // Contacts give a little, so that several that carry the same node share its load.
    constexpr auto stiffness = btScalar(0.75), softPart = btScalar(0.2);
    const btScalar margin = pairs_[contact.pair].margin, needed = depth + btScalar(contact.push);
    const btScalar whole = needed > 0 ? std::max(needed * stiffness, needed - softPart * margin) : needed;
    const ContactLaw law = {btScalar(contact.friction),
                            contact.adheres ? adhesionDisplacement(contact) : btScalar(0)};
    const btScalar closing = law.push(whole), before = btScalar(contact.push);
    contact.push = float(closing);
    contact.maxDrag = float(law.maxFriction(closing));
    contact.touched = contact.touched || closing > 0 || contact.adheres;
    push(contact, contact.normal * (closing - before));
}

// Friction holds a face at the place where it touched the node, not only its velocity: one pass leaves a part of
// the load of each small step, with which layers would creep for ever.
void SoftContacts::rub(Contact& contact) {
    const btVector3 apart = apartOf(contact);
    if (!(contact.maxDrag > 0)) {
        contact.held = apart;
        return;
    }
    const btVector3 slip = alongSurface(apart - contact.held, contact.normal);
    const btScalar length = slip.length();
    if (!(length > 0 && length < std::numeric_limits<btScalar>::max())) return;
    const btVector3 stopped = drag(slip, length, length, btScalar(contact.maxDrag));
    contact.held += slip - stopped;
    push(contact, -stopped);
}

// How far node and face have moved apart since the start of the substep, m.
btVector3 SoftContacts::apartOf(const Contact& contact) {
    btVector3 apart(0, 0, 0);
    for (std::size_t i = 0; i < 4; ++i) apart += vectorOf(*contact.moved[i]) * btScalar(contact.weights[i]);
    return apart;
}

// Moves node and face apart.
void SoftContacts::push(Contact& contact, const btVector3& apart) {
    for (std::size_t i = 0; i < 4; ++i)
        shift(*contact.moved[i],
              apart * btScalar(contact.weights[i] * contact.moved[i]->inverseMass / contact.response));
}

// Distance by which adhesion pulls node and face together in a small step, m.
btScalar SoftContacts::adhesionDisplacement(const Contact& contact) {
    const double h = contact.sheets[0]->smallStep();
    return btScalar(double(contact.adhesion) * h * h * double(contact.response));
}

void SoftContacts::finish(const std::vector<Sheet>& sheets) {
    for (const Sheet& sheet : sheets)
        std::fill(sheet.sheetFriction->adheresToCloth.begin(), sheet.sheetFriction->adheresToCloth.end(),
                  nullptr);
    for (const Contact& contact : contacts_) {
        const Pair& pair = pairs_[contact.pair];
        const float depth = depthOf(contact);
        if (contact.touched || depth > 0) {
            btSoftBody::SContact& touched = found_[contact.found].contact;
            touched.m_margin = pair.margin - (depth > 0 ? btScalar(depth) : btScalar(0));
            pair.owner->m_scontacts.push_back(touched);
        }
        const Sheet* const sheet = contact.adheres ? bodyOf(*pair.owner).sheet : nullptr;
        if (sheet) sheet->sheetFriction->adheresToCloth[contact.nodes[0]] = pair.other;
    }
    for (const Guest& guest : guests_) {
        const btVector3 moved = vectorOf(guest.moved);
        if (!(guest.moved.inverseMass > 0) || !std::isfinite(moved.x() + moved.y() + moved.z())) continue;
        guest.node->m_x = guest.start + moved;
        guest.node->m_v += (moved - guest.before - guest.own * fraction_) / (substep_ * fraction_);
    }
}

void prepareFaceTree(btSoftBody& body, const SmallStepSheet& cloth) {
    const btScalar around = body.getCollisionShape()->getMargin() + pulled(cloth);
    ATTRIBUTE_ALIGNED16(btDbvtVolume) volume;
    for (int f = 0; f < body.m_faces.size(); ++f) {
        const btSoftBody::Face& face = body.m_faces[f];
        if (!face.m_leaf) continue;
        Bounds bounds = {face.m_n[0]->m_x, face.m_n[0]->m_x};
        for (const btSoftBody::Node* corner : face.m_n) {
            bounds.take(corner->m_x);
            bounds.take(corner->m_x + vectorOf(cloth.reach(static_cast<std::size_t>(indexOf(body, corner)))));
        }
        bounds.grow(around);
        volume = btDbvtVolume::FromMM(bounds.low, bounds.high);
        body.m_fdbvt.update(face.m_leaf, volume);
    }
    body.m_fdbvt.optimizeIncremental(1);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
