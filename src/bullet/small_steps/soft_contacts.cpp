#include "bullet/small_steps/soft_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bullet/contact/contact_law.h"
#include "bullet/contact/flat_neighbours.h"
#include "bullet/sheet/face_projection.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

bool holds(const btSoftBody& body, const btSoftBody::Node& node) {
    return &node >= &body.m_nodes[0] && &node <= &body.m_nodes[body.m_nodes.size() - 1];
}

}  // namespace

struct SoftContacts::Finder final : btDbvt::ICollide {
    Finder(std::vector<Found>& found, btSoftBody& nodes, btSoftBody& faces)
        : found_(found),
          owner_(nodes),
          other_(faces),
          margin_(nodes.getCollisionShape()->getMargin() + faces.getCollisionShape()->getMargin()),
          friction_(dryFriction(nodes, faces)) {}

    void Process(const btDbvtNode* leafOfNode, const btDbvtNode* leafOfFace) override {
        auto& node = *static_cast<btSoftBody::Node*>(leafOfNode->data);
        auto& face = *static_cast<btSoftBody::Face*>(leafOfFace->data);
        const FaceProjection::Nearest nearest =
            projection_.of(node.m_x, face.m_n[0]->m_x, face.m_n[1]->m_x, face.m_n[2]->m_x);
        const btScalar distance = nearest.apart.length();
        const btScalar farthest = margin_ + 2 * (node.m_x - node.m_q).length();
        // For a node exactly in the plane of a face the outward direction is unknown.
        if (!(distance > SIMD_EPSILON && distance < farthest)) return;
        const btVector3 normal = nearest.apart / distance;
        found_.push_back({&owner_, &other_,
                          silentContact(node, face, nearest.weights, normal, farthest, friction_), margin_,
                          distance});
    }

  private:
    std::vector<Found>& found_;
    btSoftBody& owner_;
    btSoftBody& other_;
    const btScalar margin_;
    const btScalar friction_;
    FaceProjection projection_;
};

void SoftContacts::find(btSoftBody& nodes, btSoftBody& faces) {
    const std::size_t first = found_.size();
    Finder finder(found_, nodes, faces);
    nodes.m_ndbvt.collideTT(nodes.m_ndbvt.m_root, faces.m_fdbvt.m_root, finder);
    choose(first);
}

void SoftContacts::choose(std::size_t first) {
    const auto begin = found_.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(begin, found_.end(), [](const Found& a, const Found& b) {
        if (a.contact.m_node != b.contact.m_node) return a.contact.m_node < b.contact.m_node;
        return a.distance != b.distance ? a.distance < b.distance : a.contact.m_face < b.contact.m_face;
    });
    auto kept = begin;
    const Found* nearest = nullptr;
    for (auto each = begin; each != found_.end(); ++each) {
        const bool isNearest = !nearest || nearest->contact.m_node != each->contact.m_node;
        if (!isNearest && !rises(*each, *nearest)) continue;
        *kept = *each;
        if (isNearest) nearest = &*kept;
        ++kept;
    }
    found_.erase(kept, found_.end());
}

// Whether a face rises above the plane of the contact of a node with the nearest face; its own plane then
// counts, too.
bool SoftContacts::rises(Found& found, const Found& nearest) {
    const btVector3& up = nearest.contact.m_normal;
    const btVector3& place = found.contact.m_node->m_x;
    const btVector3 point = place - up * nearest.distance;
    const auto* const corners = found.contact.m_face->m_n;
    btScalar top = 0;
    for (int corner = 0; corner < 3; ++corner) top = std::max(top, up.dot(corners[corner]->m_x - point));
    if (!risesAbove(top, found.margin)) return false;
    const btVector3 normal = (corners[1]->m_x - corners[0]->m_x).cross(corners[2]->m_x - corners[0]->m_x);
    const btScalar length = normal.length();
    if (!(length > 0)) return false;
    const bool isBehind = normal.dot(place - corners[0]->m_x) < 0;
    found.contact.m_normal = normal / (isBehind ? -length : length);
    return true;
}

void SoftContacts::begin(const std::vector<Sheet>& sheets, double substep, int steps) {
    substep_ = btScalar(substep);
    fraction_ = 1 / btScalar(steps);
    isFirstStep_ = true;
    contacts_.clear();
    guests_.clear();
    // Bullet lists pairs of bodies in the order in which they first met, which is unknown to restored sheets.
    std::stable_sort(found_.begin(), found_.end(), [](const Found& a, const Found& b) {
        const int one = a.owner->getWorldArrayIndex(), two = b.owner->getWorldArrayIndex();
        return one != two ? one < two : a.other->getWorldArrayIndex() < b.other->getWorldArrayIndex();
    });
    for (const Found& found : found_) contacts_.push_back(placed(found, sheets));
    for (const Sheet& sheet : sheets) updateAdhesion(sheet, sheets);
}

void SoftContacts::updateAdhesion(const Sheet& sheet, const std::vector<Sheet>& sheets) {
    Friction& sheetFriction = *sheet.sheetFriction;
    if (!sheetFriction.canAdhere()) return;
    nearest_.assign(sheet.cloth->size(), -1);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        Contact& contact = contacts_[i];
        if (contact.sheets[0] != sheet.cloth) continue;
        int& nearest = nearest_[contact.nodes[0]];
        if (nearest < 0 || contact.gap < contacts_[static_cast<std::size_t>(nearest)].gap)
            nearest = static_cast<int>(i);
    }
    for (const int nearest : nearest_) {
        if (nearest < 0) continue;
        const auto i = static_cast<std::size_t>(nearest);
        const auto other = std::find_if(sheets.begin(), sheets.end(), [&](const Sheet& each) {
            return each.cloth == contacts_[i].sheets[1];
        });
        updateAdhesion(contacts_[i], *found_[i].other, sheetFriction,
                       other == sheets.end() ? nullptr : other->sheetFriction);
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

SoftContacts::Contact SoftContacts::placed(const Found& found, const std::vector<Sheet>& sheets) {
    Contact contact = {};
    const btSoftBody::SContact& source = found.contact;
    btVector3 apart = place(contact, 0, *source.m_node, *found.owner, sheets);
    contact.weights[0] = 1;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::size_t at = corner + 1;
        apart -= place(contact, at, *source.m_face->m_n[corner], *found.other, sheets) *
                 source.m_weights[int(corner)];
        contact.weights[at] = -float(source.m_weights[int(corner)]);
    }
    contact.normal = source.m_normal;
    contact.friction = float(source.m_friction);
    for (const Sheet& sheet : sheets)
        if (sheet.cloth == contact.sheets[0])
            contact.friction *= float(sheet.sheetFriction->frictionRatio(contact.nodes[0]));
    for (std::size_t i = 0; i < 4; ++i)
        contact.response += contact.weights[i] * contact.weights[i] * contact.moved[i]->inverseMass;
    contact.gap = float(apart.dot(source.m_normal) - found.margin);
    lift(contact, float(found.margin));
    return contact;
}

// Separates overlapping bodies.
void SoftContacts::lift(Contact& contact, float margin) {
    if (contact.gap >= 0 || !(contact.response > 0)) return;
    const float lifted = liftAtOnce(-contact.gap, margin);
    for (std::size_t i = 0; i < 4; ++i) {
        const btVector3 by = contact.normal * btScalar(lifted * contact.weights[i] *
                                                       contact.moved[i]->inverseMass / contact.response);
        if (contact.sheets[i])
            contact.sheets[i]->place(contact.nodes[i], by);
        else
            shift(*contact.moved[i], by);
    }
    contact.gap = -lifted;
}

btVector3 SoftContacts::place(Contact& contact, std::size_t corner, btSoftBody::Node& node,
                              const btSoftBody& body, const std::vector<Sheet>& sheets) {
    for (const Sheet& sheet : sheets) {
        if (!holds(*sheet.body, node)) continue;
        contact.sheets[corner] = sheet.cloth;
        contact.nodes[corner] = static_cast<std::size_t>(&node - &sheet.body->m_nodes[0]);
        contact.moved[corner] = &sheet.cloth->moved(contact.nodes[corner]);
        return sheet.cloth->startPosition(contact.nodes[corner]);
    }
    contact.sheets[corner] = nullptr;
    contact.nodes[corner] = guestOf(node, body.isActive());
    Guest& guest = guests_[contact.nodes[corner]];
    contact.moved[corner] = &guest.moved;
    return guest.start;
}

std::size_t SoftContacts::guestOf(btSoftBody::Node& node, bool isAwake) {
    for (std::size_t i = 0; i < guests_.size(); ++i)
        if (guests_[i].node == &node) return i;
    // Bullet does not move sleeping bodies, and neither does this.
    const btVector3 start = isAwake ? node.m_q : node.m_x;
    guests_.push_back({&node, start, node.m_x - start, {0, 0, 0, isAwake ? float(node.m_im) : 0}, {0, 0, 0}});
    return guests_.size() - 1;
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

btVector3 SoftContacts::step(const Contact& contact, std::size_t corner) const {
    if (contact.sheets[corner]) return contact.sheets[corner]->step(contact.nodes[corner]);
    return vectorOf(*contact.moved[corner]) - guests_[contact.nodes[corner]].before;
}

void SoftContacts::solve() {
    for (Contact& contact : contacts_) {
        if (!(contact.response > 0)) continue;
        btVector3 apart(0, 0, 0);
        for (std::size_t i = 0; i < 4; ++i)
            apart += vectorOf(*contact.moved[i]) * btScalar(contact.weights[i]);
        const btScalar depth = -(btScalar(contact.gap) + apart.dot(contact.normal));
        contact.adheres =
            adhesionHolds(contact.adhesion, contact.adheres || depth > 0, -depth, contact.reach);
        if (!((depth > 0 || contact.adheres) && std::abs(depth) < std::numeric_limits<btScalar>::max()))
            continue;  // not for values that are not finite either
        contact.touched = true;
        const ContactLaw law = {btScalar(contact.friction),
                                contact.adheres ? adhesionDisplacement(contact) : btScalar(0)};
        const btScalar closing = law.push(depth);

        btVector3 slip(0, 0, 0);
        for (std::size_t i = 0; i < 4; ++i) slip += step(contact, i) * btScalar(contact.weights[i]);
        slip = alongSurface(slip, contact.normal);
        const btScalar length = slip.length();
        btVector3 push = contact.normal * closing;
        if (length > 0) push -= drag(slip, length, length, law.maxFriction(closing));
        for (std::size_t i = 0; i < 4; ++i)
            shift(*contact.moved[i],
                  push * btScalar(contact.weights[i] * contact.moved[i]->inverseMass / contact.response));
    }
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
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const Contact& contact = contacts_[i];
        if (contact.touched) found_[i].owner->m_scontacts.push_back(found_[i].contact);
        if (!contact.adheres) continue;
        for (const Sheet& sheet : sheets)
            if (sheet.cloth == contact.sheets[0])
                sheet.sheetFriction->adheresToCloth[contact.nodes[0]] = found_[i].other;
    }
    for (const Guest& guest : guests_) {
        const btVector3 moved = vectorOf(guest.moved);
        if (!(guest.moved.inverseMass > 0) || !std::isfinite(moved.x() + moved.y() + moved.z())) continue;
        guest.node->m_x = guest.start + moved;
        guest.node->m_v += (moved - guest.before - guest.own * fraction_) / (substep_ * fraction_);
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
