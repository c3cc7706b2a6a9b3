#include "soft_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

bool holds(const btSoftBody& body, const btSoftBody::Node& node) {
    return &node >= &body.m_nodes[0] && &node <= &body.m_nodes[body.m_nodes.size() - 1];
}

}  // namespace

void SoftContacts::take(btSoftBody& owner, int first, btSoftBody& other, btScalar margin) {
    for (int i = first; i < owner.m_scontacts.size(); ++i) {
        const btSoftBody::SContact& contact = owner.m_scontacts[i];
        // Of a node in the very plane of a face Bullet does not know which way is out.
        const btVector3 all = contact.m_normal + contact.m_weights;
        if (std::isfinite(all.x() + all.y() + all.z())) found_.push_back({&owner, &other, contact, margin});
    }
    owner.m_scontacts.resize(first);
}

void SoftContacts::begin(const std::vector<Sheet>& sheets, double substep, int steps) {
    substep_ = btScalar(substep);
    share_ = 1 / btScalar(steps);
    contacts_.clear();
    guests_.clear();
    for (const Found& found : found_) contacts_.push_back(placed(found, sheets));
}

SoftContacts::Contact SoftContacts::placed(const Found& found, const std::vector<Sheet>& sheets) {
    Contact contact = {};
    const btSoftBody::SContact& source = found.contact;
    btVector3 apart = place(contact, 0, *source.m_node, *found.owner, sheets);
    contact.weights[0] = 1;
    for (int corner = 0; corner < 3; ++corner) {
        const auto at = static_cast<std::size_t>(corner + 1);
        apart -=
            place(contact, at, *source.m_face->m_n[corner], *found.other, sheets) * source.m_weights[corner];
        contact.weights[at] = -float(source.m_weights[corner]);
    }
    contact.normal = source.m_normal;
    contact.friction = float(source.m_friction);
    for (std::size_t i = 0; i < 4; ++i)
        contact.response += contact.weights[i] * contact.weights[i] * contact.moved[i]->inverseMass;
    contact.gap = float(apart.dot(source.m_normal) - found.margin);
    lift(contact, float(found.margin));
    return contact;
}

/// Takes overlapping bodies apart, without a velocity of their own and a little at a time: all at once would take
/// cloth through cloth elsewhere.
void SoftContacts::lift(Contact& contact, float margin) {
    constexpr float atOnce = 0.1f;
    if (contact.gap >= 0 || !(contact.response > 0)) return;
    const float lifted = std::min(-contact.gap, atOnce * margin);
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
        return sheet.cloth->startPlace(contact.nodes[corner]);
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
    // Bullet leaves one that sleeps where it is, and so do we.
    const btVector3 start = isAwake ? node.m_q : node.m_x;
    guests_.push_back({&node, start, node.m_x - start, {0, 0, 0, isAwake ? float(node.m_im) : 0}, {0, 0, 0}});
    return guests_.size() - 1;
}

void SoftContacts::advance() {
    for (Guest& guest : guests_) {
        guest.before = vectorOf(guest.moved);
        shift(guest.moved, guest.own * share_);
    }
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
        if (!(depth > 0 && depth < std::numeric_limits<btScalar>::max()))
            continue;  // nor for what is not finite
        contact.touched = true;

        btVector3 slip(0, 0, 0);
        for (std::size_t i = 0; i < 4; ++i) slip += step(contact, i) * btScalar(contact.weights[i]);
        slip -= contact.normal * slip.dot(contact.normal);
        const btScalar length = slip.length(), most = btScalar(contact.friction) * depth;
        btVector3 push = contact.normal * depth;
        if (length > 0) push -= slip * (std::min(most, length) / length);
        for (std::size_t i = 0; i < 4; ++i)
            shift(*contact.moved[i],
                  push * btScalar(contact.weights[i] * contact.moved[i]->inverseMass / contact.response));
    }
}

void SoftContacts::finish() {
    for (std::size_t i = 0; i < contacts_.size(); ++i)
        if (contacts_[i].touched) found_[i].owner->m_scontacts.push_back(found_[i].contact);
    for (const Guest& guest : guests_) {
        const btVector3 moved = vectorOf(guest.moved);
        if (!(guest.moved.inverseMass > 0) || !std::isfinite(moved.x() + moved.y() + moved.z())) continue;
        guest.node->m_x = guest.start + moved;
        guest.node->m_v += (moved - guest.own) / substep_;
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
