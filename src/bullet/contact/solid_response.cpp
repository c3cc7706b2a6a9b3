#include "bullet/contact/solid_response.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// The generalised velocities that unit forces along the three axes and unit torques around them give to a
// btMultiBody, at the centre of mass of one link.
class LinkImpulses {
  public:
    LinkImpulses(const btMultiBody& body, const btCollisionObject& collider, int link)
        : count_(6 + body.getNumDofs()) {
        btAlignedObjectArray<btScalar> numbers;
        btAlignedObjectArray<btVector3> vectors;
        btAlignedObjectArray<btMatrix3x3> matrices;
        jacobians_.resize(6 * size());
        velocities_.resize(6 * size());
        for (int i = 0; i < 6; ++i) {
            btVector3 along(0, 0, 0), around(0, 0, 0);
            (i < 3 ? along : around)[i % 3] = 1;
            body.fillConstraintJacobianMultiDof(link, collider.getWorldTransform().getOrigin(), around, along,
                                                row(jacobians_, i), numbers, vectors, matrices);
            body.calcAccelerationDeltasMultiDof(row(jacobians_, i), row(velocities_, i), numbers, vectors);
        }
    }

    // Velocity along (around) axis `to` by a unit impulse along (around) axis `from`.
    btScalar response(int to, int from) const {
        btScalar sum = 0;
        for (std::size_t k = 0; k < size(); ++k)
            sum += jacobians_[std::size_t(to) * size() + k] * velocities_[std::size_t(from) * size() + k];
        return sum;
    }

    // Generalised velocities by an impulse.
    std::vector<btScalar> velocities(const Wrench& impulse) const {
        std::vector<btScalar> sum(size(), 0);
        for (int i = 0; i < 6; ++i) {
            const btScalar part = (i < 3 ? impulse.force : impulse.torque)[i % 3];
            for (std::size_t k = 0; k < size(); ++k)
                sum[k] += part * velocities_[std::size_t(i) * size() + k];
        }
        return sum;
    }

  private:
    std::size_t size() const { return static_cast<std::size_t>(count_); }
    btScalar* row(std::vector<btScalar>& rows, int i) { return &rows[static_cast<std::size_t>(i) * size()]; }

    int count_;
    std::vector<btScalar> jacobians_, velocities_;
};

btMultiBodyLinkCollider* linkOf(const btCollisionObject& object) {
    return btMultiBodyLinkCollider::upcast(const_cast<btCollisionObject*>(&object));
}

void applyToLink(const btMultiBodyLinkCollider& link, const Wrench& push, const Wrench* shift) {
    btMultiBody& body = *link.m_multiBody;
    const LinkImpulses impulses(body, link, link.m_link);
    body.applyDeltaVeeMultiDof(impulses.velocities(push).data(), 1);
    if (!shift) return;
    std::vector<btScalar> moves = impulses.velocities(*shift);
    body.stepPositionsMultiDof(1, nullptr, moves.data());
    btAlignedObjectArray<btQuaternion> turns;
    btAlignedObjectArray<btVector3> places;
    body.updateCollisionObjectWorldTransforms(turns, places);
}

}  // namespace

SolidResponse::SolidResponse(const btCollisionObject& object) {
    if (linkOf(object))
        readLink(object);
    else
        readRigidBody(object);
}

void SolidResponse::readRigidBody(const btCollisionObject& object) {
    const btRigidBody* const body = btRigidBody::upcast(&object);
    if (!body || body->isStaticOrKinematicObject() || body->getActivationState() == DISABLE_SIMULATION)
        return;
    inverseMass_ = body->getInvMass();
    linearFactor_ = body->getLinearFactor();
    angularFactor_ = body->getAngularFactor();
    inverseInertia_ = body->getInvInertiaTensorWorld();
    isMovable_ = inverseMass_ > 0;
}

void SolidResponse::readLink(const btCollisionObject& object) {
    const btMultiBodyLinkCollider& link = *linkOf(object);
    // Bullet prepares the articulated inertia of bodies that are awake only.
    const bool isFixed = link.m_link < 0 && link.m_multiBody->isBaseStaticOrKinematic();
    if (!object.isActive() || object.isStaticOrKinematicObject() || isFixed) return;
    const LinkImpulses impulses(*link.m_multiBody, object, link.m_link);
    for (int to = 0; to < 3; ++to)
        for (int from = 0; from < 3; ++from) {
            linear_[to][from] = impulses.response(to, from);
            coupling_[to][from] = impulses.response(to, from + 3);
            inverseInertia_[to][from] = impulses.response(to + 3, from + 3);
        }
    isCoupled_ = isMovable_ = true;
}

void SolidResponse::wake(btCollisionObject& object) {
    const btMultiBodyLinkCollider* const link = linkOf(object);
    if (link && !object.isActive() && !object.isStaticOrKinematicObject()) link->m_multiBody->wakeUp();
}

void SolidResponse::apply(btCollisionObject& object, const Wrench& push, const Wrench* shift) {
    object.activate();
    if (const btMultiBodyLinkCollider* const link = linkOf(object)) return applyToLink(*link, push, shift);
    btRigidBody& body = *btRigidBody::upcast(&object);
    const SolidResponse response(object);
    const Twist change = response.to(push);
    body.setLinearVelocity(body.getLinearVelocity() + change.linear);
    body.setAngularVelocity(body.getAngularVelocity() + change.angular);
    if (!shift) return;
    body.setCenterOfMassTransform(moved(body.getWorldTransform(), response.to(*shift)));
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
