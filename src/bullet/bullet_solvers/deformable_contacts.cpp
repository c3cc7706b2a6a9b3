#include "bullet/bullet_solvers/deformable_contacts.h"

#include <algorithm>
#include <cmath>

#include "bullet/contact/contact_law.h"
#include "bullet/contact/solids.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// A solid that can be moved by an impulse; null for one that cannot.
btRigidBody* pushable(const btCollisionObject& object) {
    const btRigidBody* const body = movingBody(object);
    return body && !body->isStaticOrKinematicObject() ? const_cast<btRigidBody*>(body) : nullptr;
}

// An impulse between a node and a solid at the position of the node.
void exchange(btSoftBody::Node& node, const btCollisionObject& solid, const btVector3& impulse,
              bool implicit) {
    node.m_v += impulse * node.m_im;
    // The velocity from which an implicit step starts.
    if (implicit) node.m_vn += impulse * node.m_im;
    btRigidBody* const body = pushable(solid);
    if (!body) return;
    body->applyImpulse(-impulse, node.m_x - body->getCenterOfMassPosition());
    body->activate();
}

}  // namespace

void DeformableContacts::rewrite(const btCollisionWorld& world, btSoftBody& body, Friction& sheetFriction,
                                 btScalar substep, bool implicit) {
    met_.begin(world, body, sheetFriction);
    adheresTo_.assign(sheetFriction.adheresTo.size(), nullptr);
    const Substep now = {body, sheetFriction, substep, body.getCollisionShape()->getMargin(), implicit};
    order_.sort(body.m_nodeRigidContacts, [](const auto& contact) { return contact.m_node; });
    order_.sort(body.m_faceRigidContacts, [](const auto& contact) { return contact.m_face; });
    for (int i = 0; i < body.m_nodeRigidContacts.size(); ++i) rewrite(body.m_nodeRigidContacts[i], now);
    for (int i = 0; i < body.m_faceRigidContacts.size(); ++i) rewrite(body.m_faceRigidContacts[i], now);
    for (std::size_t n = 0; n < adheresTo_.size(); ++n)
        if (sheetFriction.adheresTo[n] && !adheresTo_[n] && sheetFriction.adhesion(n) > 0)
            hold(n, sheetFriction.adheresTo[n], now);
    sheetFriction.adheresTo.swap(adheresTo_);
}

void DeformableContacts::rewrite(btSoftBody::DeformableNodeRigidContact& contact, const Substep& now) {
    btSoftBody::Node& node = *contact.m_node;
    const btCollisionObject& object = *contact.m_cti.m_colObj;
    const MetSolids::Met& met = met_.at(&object);
    if (!(node.m_im > 0) || !met.exists) return;
    const auto n = static_cast<std::size_t>(&node - &now.body.m_nodes[0]);
    const double friction = now.sheetFriction.friction(met.surface, n);
    contact.m_c3 = btScalar(friction);
    const double adhesion = now.sheetFriction.adhesion(met.surface, n);
    if (!(adhesion > 0) || object.getInternalType() == btCollisionObject::CO_FEATHERSTONE_LINK) return;
    const btVector3& normal = contact.m_cti.m_normal;
    const btScalar approach = -(node.m_v - velocityAt(object, node.m_x)).dot(normal);
    if (contact.m_cti.m_offset > approach * now.time) return;
    adheresTo_[n] = &object;
    if (!now.implicit) return exchange(node, object, normal * (-btScalar(adhesion) * now.time), now.implicit);
    // Bullet's implicit contacts respond with more than the mass of the node.
    constexpr double max = 30;
    const double pull = adhesion * double(now.time) * double(node.m_im);
    contact.m_c3 = btScalar(friction * (approach > 0 ? std::min(1 + pull / double(approach), max) : max));
}

void DeformableContacts::rewrite(btSoftBody::DeformableFaceRigidContact& contact, const Substep& now) {
    const MetSolids::Met& met = met_.at(contact.m_cti.m_colObj);
    if (!met.exists) return;
    double friction = 0;
    for (int corner = 0; corner < 3; ++corner) {
        const auto n = static_cast<std::size_t>(contact.m_face->m_n[corner] - &now.body.m_nodes[0]);
        friction += double(contact.m_bary[corner]) * now.sheetFriction.friction(met.surface, n);
    }
    contact.m_c3 = btScalar(friction);
}

void DeformableContacts::hold(std::size_t n, const btCollisionObject* solid, const Substep& now) {
    btSoftBody::Node& node = now.body.m_nodes[static_cast<int>(n)];
    if (!(node.m_im > 0) || node.m_battach) return;
    const MetSolids::Met& met = met_.at(solid);
    const double adhesion = met.exists ? now.sheetFriction.adhesion(met.surface, n) : 0.0;
    if (!(adhesion > 0)) return;
    const SurfacePoint surface = nearestSurfaceOf(*solid, node.m_x, now.body.m_worldInfo->m_sparsesdf);
    const btVector3 slip = node.m_v - velocityAt(*solid, node.m_x);
    const btScalar leaving = slip.dot(surface.normal),
                   gap = surface.distance - now.margin + leaving * now.time;
    if (!adhesionHolds(adhesion, true, gap, btScalar(now.sheetFriction.reach()))) return;
    adheresTo_[n] = solid;
    if (gap <= 0) return;
    const btRigidBody* const body = pushable(*solid);
    const auto responseAlong = [&](const btVector3& direction) {
        return node.m_im + (body ? body->computeImpulseDenominator(node.m_x, direction) : 0);
    };
    const btScalar response = responseAlong(surface.normal);
    const ContactLaw law = {btScalar(now.sheetFriction.friction(met.surface, n)),
                            btScalar(adhesion) * now.time};
    const btScalar push = law.push(-gap / (now.time * response));
    const btVector3 along = alongSurface(slip, surface.normal);
    const btScalar speed = along.length();
    btVector3 impulse = surface.normal * push;
    // An implicit contact, which accounts for everything that holds the node, has friction; an estimate from
    // the mass of the node alone makes it jitter.
    if (speed > 0 && !now.implicit)
        impulse -= drag(along, speed, speed / responseAlong(along / speed), law.maxFriction(push));
    exchange(node, *solid, impulse, now.implicit);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
