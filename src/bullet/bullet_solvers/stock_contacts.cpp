#include "bullet/bullet_solvers/stock_contacts.h"

#include <algorithm>
#include <cmath>

#include "bullet/contact/contact_law.h"
#include "bullet/contact/flat_neighbours.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// Moves a node as a force would, so that Bullet derives a velocity from the new position, or before Bullet
// does so.
void displace(btSoftBody::Node& node, const btVector3& by, btScalar substep) {
    node.m_x += by;
    node.m_v += by / substep;
}

// Moves a node without changing its velocity.
void lift(btSoftBody::Node& node, const btVector3& by) {
    node.m_x += by;
    node.m_q += by;
}

// Makes Bullet ignore a contact.
void silence(btSoftBody::RContact& contact) {
    contact.m_c0 = btMatrix3x3(0, 0, 0, 0, 0, 0, 0, 0, 0);
    contact.m_c2 = 0;
}

}  // namespace

void StockContacts::rewrite(const btCollisionWorld& world, btSoftBody& body, Friction& sheetFriction) {
    met_.begin(world, body, sheetFriction);
    solids_.clear();
    held_.clear();
    heldAt_.assign(sheetFriction.adheresTo.size(), -1);
    adheresTo_.assign(sheetFriction.adheresTo.size(), nullptr);
    stuck_.swap(stuckBefore_);
    stuck_.assign(adheresTo_.size(), {});
    stuckBefore_.resize(adheresTo_.size());
    order_.sort(body.m_rcontacts, [](const btSoftBody::RContact& contact) { return contact.m_node; });
    for (int i = 0; i < body.m_rcontacts.size(); ++i) rewrite(body.m_rcontacts[i], body, sheetFriction);
    findAdhering(body, sheetFriction);

    const auto substep = double(body.m_sst.sdt);
    solids_.begin(substep, Motors());  // contacts with multibodies are Bullet's
    solids_.advance(substep);
    for (const Held& held : held_) hold(body, held, btScalar(sheetFriction.reach()));
    solids_.finish(body.m_worldInfo->m_dispatcher);
    sheetFriction.adheresTo.swap(adheresTo_);
}

void StockContacts::rewrite(btSoftBody::RContact& contact, btSoftBody& body, const Friction& sheetFriction) {
    btSoftBody::Node& node = *contact.m_node;
    const btCollisionObject& object = *contact.m_cti.m_colObj;
    if (!(node.m_im > 0) || object.getInternalType() == btCollisionObject::CO_FEATHERSTONE_LINK) return;
    const MetSolids::Met& met = met_.at(&object);
    if (!met.exists) return;
    const btScalar margin = body.getCollisionShape()->getMargin();
    const btRigidBody* const rigid = btRigidBody::upcast(&object);
    const btVector3 ofSolid =
        rigid ? rigid->getVelocityInLocalPoint(contact.m_c1) * body.m_sst.sdt : btVector3(0, 0, 0);
    const btVector3 motion = node.m_x - node.m_q - ofSolid;

    // Bullet has searched at the position of the solid at the start of the substep. Its distance field must
    // be used, even if it is coarse: nodes lifted to another surface would fall back to Bullet's.
    SurfacePoint surface;
    surface.normal = contact.m_cti.m_normal;
    surface.distance = surface.normal.dot(node.m_x - ofSolid) + contact.m_cti.m_offset + margin;
    const btScalar approach = motion.dot(surface.normal), start = surface.distance - margin - approach;
    // A node that was inside before and stays inside is moved out by at most the margin plus its own motion.
    const btScalar lifted = std::clamp(-start, btScalar(0), margin + motion.length());
    lift(node, surface.normal * lifted);
    surface.distance += lifted;
    contact.m_cti.m_offset = surface.distance - margin - surface.normal.dot(node.m_x);
    if (surface.distance >= margin) return silence(contact);

    contact.m_c3 = 1;  // no friction
    contact.m_c4 = 0;  // no push
    const int n = static_cast<int>(&node - &body.m_nodes[0]);
    const auto index = static_cast<std::size_t>(n);
    const double adhesion = sheetFriction.adhesion(met.surface, index);
    if (adhesion > 0) adheresTo_[index] = &object;
    add({n, indexOf(object, body), surface, std::max(btScalar(0), -approach), true, adhesion,
         sheetFriction.friction(met.surface, index)});
}

std::size_t StockContacts::indexOf(const btCollisionObject& object, const btSoftBody& body) {
    // Bullet passes solids as const, although they may be pushed.
    return solids_.add(const_cast<btCollisionObject&>(object), pathByVelocities(object, body.m_sst.sdt));
}

// Parts of one surface that face a node, such as the boxes or triangles of a floor, act as a single contact.
void StockContacts::add(const Held& held) {
    int& at = heldAt_[static_cast<std::size_t>(held.node)];
    if (at >= 0) {
        Held& other = held_[static_cast<std::size_t>(at)];
        if (faceAlike(other.surface.normal, held.surface.normal)) {
            if (held.approach > other.approach) other = held;
            return;
        }
    }
    at = static_cast<int>(held_.size());
    held_.push_back(held);
}

void StockContacts::findAdhering(btSoftBody& body, const Friction& sheetFriction) {
    for (std::size_t n = 0; n < adheresTo_.size(); ++n) {
        if (!sheetFriction.adheresTo[n] || adheresTo_[n] || !(sheetFriction.adhesion(n) > 0)) continue;
        const btSoftBody::Node& node = body.m_nodes[static_cast<int>(n)];
        if (!(node.m_im > 0) || node.m_battach) continue;
        const MetSolids::Met& met = met_.at(sheetFriction.adheresTo[n]);
        const double adhesion = met.exists ? sheetFriction.adhesion(met.surface, n) : 0.0;
        if (!(adhesion > 0)) continue;
        const SurfacePoint surface = nearestSurfaceOf(*met.object, node.m_x, body.m_worldInfo->m_sparsesdf);
        if (!std::isfinite(surface.distance)) continue;
        held_.push_back({static_cast<int>(n), indexOf(*met.object, body), surface, 0, false, adhesion,
                         sheetFriction.friction(met.surface, n)});
    }
}

void StockContacts::hold(btSoftBody& body, const Held& held, btScalar reach) {
    btSoftBody::Node& node = body.m_nodes[held.node];
    Solid& solid = solids_[held.solid];
    const btVector3& normal = held.surface.normal;
    const btScalar substep = body.m_sst.sdt;
    const btVector3 arm =
        solid.unturned(node.m_x - normal * held.surface.distance - solid.path().end.getOrigin());
    const btScalar response = node.m_im + solid.response(arm, normal);
    const ContactLaw law = {btScalar(held.friction), btScalar(held.adhesion) * substep * substep};
    btScalar push = law.push(held.approach / response);
    if (!held.isInContact) {
        const btScalar margin = body.getCollisionShape()->getMargin(),
                       gap = held.surface.distance - margin - normal.dot(solid.shiftOf(arm));
        if (!adhesionHolds(held.adhesion, true, gap, reach)) return;
        adheresTo_[static_cast<std::size_t>(held.node)] = &solid.object();
        push = law.push(-std::max(gap, btScalar(0)) / response);
    }

    const btVector3 slip = alongSurface(node.m_x - node.m_q - solid.step(arm), normal);
    // A solid that can rotate yields more to a tangential force than to a normal one.
    const btScalar length = slip.length(),
                   compliance = length > 0 ? node.m_im + solid.response(arm, slip / length) : response,
                   stopping = length / compliance, maxFriction = law.maxFriction(push);
    const bool sticks = stopping <= maxFriction;
    btVector3 total(0, 0, 0);
    if (length > 0) total = -drag(slip, length, stopping, maxFriction);
    if (!held.isInContact) total += normal * push;  // otherwise Bullet does that
    displace(node, total * node.m_im, substep);
    solid.push(arm, -total);
    if (sticks) stick(body, held);
}

void StockContacts::stick(btSoftBody& body, const Held& held) {
    btSoftBody::Node& node = body.m_nodes[held.node];
    const btTransform& transform = solids_[held.solid].path().end;
    const auto n = static_cast<std::size_t>(held.node);
    const btCollisionObject* const object = &solids_[held.solid].object();
    if (stuckBefore_[n].object == object) {
        const btVector3 back = transform * stuckBefore_[n].position - node.m_x;
        // The application has moved the sheet or the solid if the distance is larger than links could have
        // caused.
        const btScalar max = body.getCollisionShape()->getMargin() + (node.m_x - node.m_q).length();
        if (back.length() <= max) lift(node, alongSurface(back, held.surface.normal));
    }
    stuck_[n] = {object, transform.invXform(node.m_x)};
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
