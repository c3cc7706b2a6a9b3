#include <vector>

#include "bullet/sheet/rest_shape.h"
#include "bullet/state/body_state.h"
#include "checks/checks.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

using Which = BulletPass::Which;

void ContactState::state(BulletPass& pass) {
    solids(pass);
    softBodies(pass);
    if (!isDeformable_) return;
    deformableSolids(pass);
    deformableSoftBodies(pass);
}

// Bullet's contacts have no default constructor: this empty one is filled by what is read.
template <typename Contacts, typename IsKnown, typename Each>
void ContactState::list(BulletPass& pass, Contacts& contacts, IsKnown isKnown, Each each) {
    std::vector<int> known;
    if (pass.saves())
        for (int i = 0; i < contacts.size(); ++i)
            if (owns(contacts[i].m_node) && isKnown(contacts[i])) known.push_back(i);
    const std::size_t count = pass.count(known.size(), 1u << 24);
    if (!pass.saves()) contacts.reserve(static_cast<int>(count));
    if (pass.restores()) contacts.resize(0);
    for (std::size_t i = 0; i < count; ++i) {
        if (pass.saves()) {
            each(contacts[known[i]]);
            continue;
        }
        auto read = std::decay_t<decltype(contacts[0])>();
        each(read);
        if (pass.restores()) contacts.push_back(read);
    }
}

bool ContactState::owns(const btSoftBody::Node* node) const {
    return node >= &body_.m_nodes[0] && node < &body_.m_nodes[0] + body_.m_nodes.size();
}

template <typename Contact>
void ContactState::node(BulletPass& pass, Contact& contact) {
    const auto index =
        pass.value(static_cast<std::int32_t>(pass.saves() ? indexOf(body_, contact.m_node) : 0), 0,
                   body_.m_nodes.size() - 1);
    if (pass.restores()) contact.m_node = &body_.m_nodes[index];
}

// @return the body of the face
template <typename Contact>
const btCollisionObject* ContactState::face(BulletPass& pass, Contact& contact) {
    const btSoftBody* const ownerNow = pass.saves() ? pass.ownerOf(contact.m_face) : nullptr;
    const auto* const owner = static_cast<const btSoftBody*>(pass.object(ownerNow, Which::soft));
    const int faces = owner ? owner->m_faces.size() : 0;
    const auto now = ownerNow ? static_cast<std::int32_t>(contact.m_face - &ownerNow->m_faces[0]) : 0;
    const auto index = pass.value(now, 0, faces - 1);
    if (pass.restores()) contact.m_face = const_cast<btSoftBody::Face*>(&owner->m_faces[index]);
    return owner;
}

void ContactState::touched(BulletPass& pass, btSoftBody::sCti& found) {
    found.m_colObj = pass.object(pass.saves() ? found.m_colObj : nullptr, Which::solid);
    if (!found.m_colObj) refuse<std::runtime_error>("a saved contact is with nothing");
    pass.vector(found.m_normal);
    pass.number(found.m_offset);
}

void ContactState::solids(BulletPass& pass) {
    const auto isKnown = [&](const btSoftBody::RContact& contact) {
        return pass.knows(contact.m_cti.m_colObj);
    };
    list(pass, body_.m_rcontacts, isKnown, [&](btSoftBody::RContact& contact) {
        node(pass, contact);
        touched(pass, contact.m_cti);
        if (pass.restores()) contact.m_c0.setIdentity();
        pass.vector(contact.m_c1);
        for (btScalar* part : {&contact.m_c2, &contact.m_c3, &contact.m_c4}) pass.number(*part);
    });
}

void ContactState::softBodies(BulletPass& pass) {
    const auto isKnown = [&](const btSoftBody::SContact& contact) {
        return pass.ownerOf(contact.m_face) != nullptr;
    };
    list(pass, body_.m_scontacts, isKnown, [&](btSoftBody::SContact& contact) {
        node(pass, contact);
        face(pass, contact);
        pass.vector(contact.m_weights);
        pass.vector(contact.m_normal);
        for (btScalar* part : {&contact.m_margin, &contact.m_friction, &contact.m_cfm[0], &contact.m_cfm[1]})
            pass.number(*part);
    });
}

void ContactState::deformableSolids(BulletPass& pass) {
    using Contact = btSoftBody::DeformableNodeRigidContact;
    const auto isKnown = [&](const Contact& contact) { return pass.knows(contact.m_cti.m_colObj); };
    list(pass, body_.m_nodeRigidContacts, isKnown, [&](Contact& contact) {
        node(pass, contact);
        touched(pass, contact.m_cti);
        pass.vector(contact.m_c1);
        for (btScalar* part : {&contact.m_c2, &contact.m_c3, &contact.m_c4}) pass.number(*part);
    });
}

void ContactState::deformableSoftBodies(BulletPass& pass) {
    using Contact = btSoftBody::DeformableFaceNodeContact;
    const auto isKnown = [&](const Contact& contact) { return pass.ownerOf(contact.m_face) != nullptr; };
    list(pass, body_.m_faceNodeContacts, isKnown, [&](Contact& contact) {
        node(pass, contact);
        const btCollisionObject* const owner = face(pass, contact);
        if (pass.restores()) contact.m_colObj = owner;
        for (btVector3* part : {&contact.m_bary, &contact.m_weights, &contact.m_normal}) pass.vector(*part);
        for (btScalar* part : {&contact.m_margin, &contact.m_friction, &contact.m_imf, &contact.m_c0})
            pass.number(*part);
    });
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
