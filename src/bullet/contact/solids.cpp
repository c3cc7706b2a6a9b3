#include "bullet/contact/solids.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <LinearMath/btTransformUtil.h>

#include <algorithm>

#include "bullet/world/limits.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

btRigidBody* rigidBody(const btCollisionObject& object) {
    // Bullet passes solids as const, although they may be pushed.
    return btRigidBody::upcast(const_cast<btCollisionObject*>(&object));
}

bool touchesSolids(const btCollisionObject& object, btDispatcher* dispatcher) {
    for (int i = 0; dispatcher && i < dispatcher->getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher->getManifoldByIndexInternal(i);
        if (manifold.getNumContacts() > 0 &&
            (manifold.getBody0() == &object || manifold.getBody1() == &object))
            return true;
    }
    return false;
}

}  // namespace

const btRigidBody* movingBody(const btCollisionObject& object) {
    const btRigidBody* const body = btRigidBody::upcast(&object);
    if (!body || body->getActivationState() == DISABLE_SIMULATION) return nullptr;
    // Kinematic bodies are often flagged static as well.
    return body->isKinematicObject() || !body->isStaticObject() ? body : nullptr;
}

void Solid::begin(double substep) {
    substep_ = remaining_ = btScalar(substep);
    const btRigidBody* const body = movingBody(*object_);
    if (!body) return;
    velocity_ = body->getLinearVelocity();
    spin_ = body->getAngularVelocity();
    if (body->isKinematicObject()) return;
    linearFactor_ = body->getLinearFactor();
    angularFactor_ = body->getAngularFactor();
    inverseMass_ = body->getInvMass();
    inverseInertia_ = body->getInvInertiaTensorWorld();
}

void Solid::advance(double smallStep) {
    smallStep_ = btScalar(smallStep);
    remaining_ = std::max(btScalar(0), remaining_ - smallStep_);
    shift_ += addedVelocity_ * smallStep_;
    turn_ += addedSpin_ * smallStep_;
}

void Solid::finish(btDispatcher* dispatcher) {
    if (addedVelocity_.isZero() && addedSpin_.isZero()) return;
    // The reaction of a sheet that became unstable, and was held at its position, must not affect other
    // bodies.
    const btVector3 all =
        addedVelocity_.absolute() + addedSpin_.absolute() + shift_.absolute() + turn_.absolute();
    if (!(double(all.x() + all.y() + all.z()) <= fastestNode)) return;
    btRigidBody* const body = rigidBody(*object_);
    body->setLinearVelocity(body->getLinearVelocity() + addedVelocity_);
    body->setAngularVelocity(body->getAngularVelocity() + addedSpin_);
    body->activate();
    if (touchesSolids(*object_, dispatcher)) return;
    btTransform transform;
    btTransformUtil::integrateTransform(body->getWorldTransform(), shift_, turn_, 1, transform);
    body->setCenterOfMassTransform(transform);
}

btScalar Solid::response(const btVector3& arm, const btVector3& direction) const {
    if (!isMovable()) return 0;
    const btVector3 lever = arm.cross(direction);
    return inverseMass_ * direction.dot(direction * linearFactor_) +
           lever.dot(inverseInertia_ * lever * angularFactor_);
}

void Solid::push(const btVector3& arm, const btVector3& push) {
    if (!isMovable()) return;
    const btVector3 move = push * linearFactor_ * inverseMass_,
                    turn = inverseInertia_ * arm.cross(push) * angularFactor_;
    shift_ += move;
    turn_ += turn;
    addedVelocity_ += move / smallStep_;
    addedSpin_ += turn / smallStep_;
}

std::size_t Solids::indexOf(const btCollisionObject& object) {
    for (std::size_t i = 0; i < solids_.size(); ++i)
        if (&solids_[i].object() == &object) return i;
    solids_.emplace_back(object);
    return solids_.size() - 1;
}

void Solids::begin(double substep) {
    for (Solid& solid : solids_) solid.begin(substep);
}

void Solids::advance(double smallStep) {
    for (Solid& solid : solids_) solid.advance(smallStep);
}

void Solids::finish(btDispatcher* dispatcher) {
    for (Solid& solid : solids_) solid.finish(dispatcher);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
