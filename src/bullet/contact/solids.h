// Solid bodies as the small steps meet them: they go their way, and feel what pushes them.
#pragma once

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <vector>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// The body of a solid that moves by itself or when pushed; none for one that stays where it is.
const btRigidBody* movingBody(const btCollisionObject& object);

// One solid in one substep. Bullet has moved it to the substep's end when the sheets come to be solved; within
// the substep it is on its way there. What pushes it here changes its velocity, and moves it from there on.
class Solid {
  public:
    explicit Solid(const btCollisionObject& object) : object_(&object) {}

    // Reads where it has come to.
    void begin(double substep);
    // Goes on by one small step.
    void advance(double smallStep);
    // Hands the changes over: of velocity, and of place, without which the cloth would find it elsewhere in
    // the next substep than it has left it. A body that other solids hold keeps its place, however: they
    // would have to push it back out of themselves, and Bullet does that slowly.
    void finish(btDispatcher* dispatcher);

    const btCollisionObject& object() const { return *object_; }
    bool isMovable() const { return inverseMass_ > 0; }
    bool isMoving() const { return !velocity_.isZero() || !spin_.isZero(); }
    // How far its centre of mass goes in the substep by itself, m.
    btVector3 path() const { return velocity_ * substep_; }
    const btTransform& end() const { return object_->getWorldTransform(); }

    // The arm of a point, which turns with the solid, in the middle of the substep: what the substep as a
    // whole does with the point is right to second order with it.
    btVector3 middle(const btVector3& armAtEnd) const {
        return armAtEnd - spin_.cross(armAtEnd) * (substep_ / 2);
    }

    // How far a point at `arm` from the centre of mass is from where it will be at the end of the substep.
    btVector3 displacement(const btVector3& arm) const {
        return shift_ + turn_.cross(arm) - (velocity_ + spin_.cross(arm)) * remaining_;
    }
    // How far that point comes in a small step.
    btVector3 step(const btVector3& arm) const {
        return (velocity_ + addedVelocity_ + (spin_ + addedSpin_).cross(arm)) * smallStep_;
    }
    // How readily that point gives way along a direction, 1/kg.
    btScalar response(const btVector3& arm, const btVector3& direction) const;
    // Pushes that point.
    // @param push  impulse x small step of the world, kg m
    void push(const btVector3& arm, const btVector3& push);

  private:
    const btCollisionObject* object_;
    btVector3 velocity_ = {0, 0, 0};       // of its own, m/s
    btVector3 spin_ = {0, 0, 0};           // of its own, 1/s
    btVector3 addedVelocity_ = {0, 0, 0};  // by pushes, m/s
    btVector3 addedSpin_ = {0, 0, 0};      // by pushes, 1/s
    btVector3 shift_ = {0, 0, 0};          // by pushes, m
    btVector3 turn_ = {0, 0, 0};           // by pushes, rad
    btVector3 linearFactor_ = {1, 1, 1};   // how far each axis may move
    btVector3 angularFactor_ = {1, 1, 1};  // how far it may turn
    btMatrix3x3 inverseInertia_ = btMatrix3x3(0, 0, 0, 0, 0, 0, 0, 0, 0);
    btScalar inverseMass_ = 0;
    btScalar substep_ = 0;    // s
    btScalar smallStep_ = 0;  // s
    btScalar remaining_ = 0;  // of the substep, s
};

// The solids that sheets meet in a substep.
class Solids {
  public:
    void clear() { solids_.clear(); }
    // Index of a solid, which is taken up if it is new.
    std::size_t indexOf(const btCollisionObject& object);
    Solid& operator[](std::size_t index) { return solids_[index]; }
    const Solid& operator[](std::size_t index) const { return solids_[index]; }

    void begin(double substep);
    void advance(double smallStep);
    void finish(btDispatcher* dispatcher);

  private:
    std::vector<Solid> solids_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
