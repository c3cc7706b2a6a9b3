#include "bullet/contact/solids.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <algorithm>

#include "bullet/world/limits.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

bool touchesSolids(const btCollisionObject& object, btDispatcher* dispatcher) {
    for (int i = 0; dispatcher && i < dispatcher->getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher->getManifoldByIndexInternal(i);
        if (manifold.getNumContacts() > 0 &&
            (manifold.getBody0() == &object || manifold.getBody1() == &object))
            return true;
    }
    return false;
}

btScalar size(const btVector3& v) {
    const btVector3 each = v.absolute();
    return each.x() + each.y() + each.z();
}

}  // namespace

const btRigidBody* movingBody(const btCollisionObject& object) {
    const btRigidBody* const body = btRigidBody::upcast(&object);
    if (!body || body->getActivationState() == DISABLE_SIMULATION) return nullptr;
    // Kinematic bodies are often flagged static as well.
    return body->isKinematicObject() || !body->isStaticObject() ? body : nullptr;
}

Twist velocitiesOf(const btCollisionObject& object) {
    if (const btRigidBody* const body = movingBody(object))
        return {body->getLinearVelocity(), body->getAngularVelocity()};
    const btMultiBodyLinkCollider* const collider = btMultiBodyLinkCollider::upcast(&object);
    if (!collider) return {};
    const btMultiBody& body = *collider->m_multiBody;
    if (collider->m_link < 0) return {body.getBaseVel(), body.getBaseOmega()};
    const btSpatialMotionVector& velocity = body.getLink(collider->m_link).m_absFrameTotVelocity;
    const btMatrix3x3& basis = object.getWorldTransform().getBasis();
    return {basis * velocity.getLinear(), basis * velocity.getAngular()};
}

SolidPath pathByVelocities(const btCollisionObject& object, btScalar substep) {
    const btTransform& end = object.getWorldTransform();
    const Twist motion = velocitiesOf(object) * substep;
    return {motion.isZero() ? end : moved(end, motion * -1), end};
}

void Solid::begin(double substep, bool isDriven) {
    isDriven_ = isDriven;
    substep_ = btScalar(substep);
    elapsed_ = smallStep_ = 0;
    response_ = SolidResponse(*object_);
    isMoving_ = path_.isMoving();
    if (isMoving_) own_ = path_.motion() * (1 / substep_);
    isStill_ = !isMoving_ && !response_.isMovable();
    isTurning_ = isMoving_ && !own_.angular.isZero();
}

btTransform Solid::poseAt(btScalar time, const Twist& shift) const {
    btTransform pose = path_.start;
    if (isMoving_) pose = moved(pose, own_ * time);
    return isMovable() ? moved(pose, shift) : pose;
}

void Solid::advance(double smallStep) {
    smallStep_ = btScalar(smallStep);
    elapsed_ += smallStep_;
    if (isMoving_) moved_ = own_.linear * elapsed_;
    if (isTurning_) turn_ = rotation(own_.angular * elapsed_);
    shiftBefore_ = shift_;
    if (!isTouched_) return;
    shift_.linear += added_.linear * smallStep_;
    shift_.angular += added_.angular * smallStep_;
    displacing_.force += pushes_.force * smallStep_;
    displacing_.torque += pushes_.torque * smallStep_;
}

void Solid::finish(btDispatcher* dispatcher) {
    if (!isTouched_) return;
    if (!response_.isMovable()) return SolidResponse::wake(*object_);
    // The reaction of a sheet that became unstable, and was held at its position, must not affect other
    // bodies.
    const Twist change = response_.to(pushes_);
    const btScalar all =
        size(change.linear) + size(change.angular) + size(shift_.linear) + size(shift_.angular);
    if (!(double(all) <= fastestNode)) return;
    const bool isHeld = isDriven_ || touchesSolids(*object_, dispatcher);
    SolidResponse::apply(*object_, pushes_, isHeld ? nullptr : &displacing_);
}

btScalar Solid::response(const btVector3& arm, const btVector3& direction) const {
    if (!isMovable()) return 0;
    const btVector3 lever = turned(arm).cross(direction);
    const Twist change = response_.to({direction, lever});
    return direction.dot(change.linear) + lever.dot(change.angular);
}

void Solid::push(const btVector3& arm, const btVector3& push) {
    touch();
    if (!response_.isMovable()) return;
    const Wrench wrench = {push, turned(arm).cross(push)};
    pushes_.force += wrench.force / smallStep_;
    pushes_.torque += wrench.torque / smallStep_;
    if (isDriven_) return;
    const Twist change = response_.to(wrench);
    shift_.linear += change.linear;
    shift_.angular += change.angular;
    added_.linear += change.linear / smallStep_;
    added_.angular += change.angular / smallStep_;
    displacing_.force += wrench.force;
    displacing_.torque += wrench.torque;
}

std::size_t Solids::add(btCollisionObject& object, const SolidPath& path) {
    for (std::size_t i = 0; i < solids_.size(); ++i)
        if (&solids_[i].object() == &object) return i;
    solids_.emplace_back(object, path);
    return solids_.size() - 1;
}

void Solids::begin(double substep, const Motors& motors) {
    for (Solid& solid : solids_) solid.begin(substep, motors.drive(solid.object()));
}

void Solids::advance(double smallStep) {
    for (Solid& solid : solids_) solid.advance(smallStep);
}

void Solids::finish(btDispatcher* dispatcher) {
    for (Solid& solid : solids_) solid.finish(dispatcher);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
