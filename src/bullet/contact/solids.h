// Rigid bodies as seen by the small steps: they move along their path, and react to impulses.
#pragma once

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <vector>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// The rigid body of a solid that moves by itself or when pushed; null for a static one.
const btRigidBody* movingBody(const btCollisionObject& object);

// One solid in one substep. Bullet has already moved it to its position at the end of the substep when the
// sheets are solved; here it moves there in small steps. Impulses from the cloth change its velocity, and its
// position from then on.
class Solid {
  public:
    explicit Solid(const btCollisionObject& object) : object_(&object) {}

    // Reads its position at the end of the substep.
    void begin(double substep);
    // Advances by one small step.
    void advance(double smallStep);
    // Applies the changes of velocity and position to Bullet's body. The position must change too, or in the
    // next substep the cloth would find the solid at another position than it left it. If other solids touch
    // the body, its position is kept, because Bullet would move it out of them only slowly.
    void finish(btDispatcher* dispatcher);

    const btCollisionObject& object() const { return *object_; }
    bool isMovable() const { return inverseMass_ > 0; }
    bool isMoving() const { return !velocity_.isZero() || !spin_.isZero(); }
    // Displacement of its centre of mass in the substep by its own velocity, m.
    btVector3 path() const { return velocity_ * substep_; }
    const btTransform& end() const { return object_->getWorldTransform(); }

    // The arm of a point in the middle of the substep; it rotates with the solid. With it, the motion of the
    // point over the whole substep is accurate to second order.
    btVector3 middle(const btVector3& armAtEnd) const {
        return armAtEnd - spin_.cross(armAtEnd) * (substep_ / 2);
    }

    // Present displacement of a point at `arm` from the centre of mass, relative to its original position at
    // the end of the substep.
    btVector3 displacement(const btVector3& arm) const {
        return shift_ + turn_.cross(arm) - (velocity_ + spin_.cross(arm)) * remaining_;
    }
    // Displacement of that point in a small step.
    btVector3 step(const btVector3& arm) const {
        return (velocity_ + addedVelocity_ + (spin_ + addedSpin_).cross(arm)) * smallStep_;
    }
    // Response of that point to an impulse along a direction: an inverse mass, 1/kg.
    btScalar response(const btVector3& arm, const btVector3& direction) const;
    // Applies an impulse at that point.
    // @param push  impulse x small step of the world, kg m
    void push(const btVector3& arm, const btVector3& push);

  private:
    const btCollisionObject* object_;
    btVector3 velocity_ = {0, 0, 0};       // own velocity, m/s
    btVector3 spin_ = {0, 0, 0};           // own angular velocity, rad/s
    btVector3 addedVelocity_ = {0, 0, 0};  // from impulses, m/s
    btVector3 addedSpin_ = {0, 0, 0};      // from impulses, rad/s
    btVector3 shift_ = {0, 0, 0};          // from impulses, m
    btVector3 turn_ = {0, 0, 0};           // from impulses, rad
    btVector3 linearFactor_ = {1, 1, 1};   // Bullet's linear factor
    btVector3 angularFactor_ = {1, 1, 1};  // Bullet's angular factor
    btMatrix3x3 inverseInertia_ = btMatrix3x3(0, 0, 0, 0, 0, 0, 0, 0, 0);
    btScalar inverseMass_ = 0;
    btScalar substep_ = 0;    // s
    btScalar smallStep_ = 0;  // s
    btScalar remaining_ = 0;  // time left in the substep, s
};

// The solids that sheets touch in a substep.
class Solids {
  public:
    void clear() { solids_.clear(); }
    // Index of a solid, which is added if it is new.
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
