// Solids as seen by the small steps: they move from their pose at the start of the substep to that at its end, and react
// to impulses.
#pragma once

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <vector>

#include "bullet/contact/motors.h"
#include "bullet/contact/rigid_motion.h"
#include "bullet/contact/solid_response.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// The rigid body of a solid that moves by itself or when pushed; null for a static one.
const btRigidBody* movingBody(const btCollisionObject& object);

// The velocities with which a solid is about to move, as far as Bullet knows them before it solves the substep:
// those of a rigid body, or of a link of a btMultiBody at the end of its last substep. 0 for any other.
Twist velocitiesOf(const btCollisionObject& object);

// The path by which a solid has come to where it is now with Bullet's velocities.
SolidPath pathByVelocities(const btCollisionObject& object, btScalar substep);

// One solid in one substep. When the sheets are solved, Bullet has already moved it to the end of its path; here it moves
// there in small steps. Impulses from the cloth change its velocity, and its position from then on. An arm is a vector
// from the centre of mass to a point of the solid, at the start of the substep.
class Solid {
  public:
    // @param start  of its path, at the end of which it is now
    Solid(btCollisionObject& object, const SolidPath& path) : object_(&object), path_(path) {}

    // @pre Bullet has solved the substep
    // @param isDriven  by a motor, which holds it in this substep; impulses change its velocity at the end only
    void begin(double substep, bool isDriven);
    // Advances by one small step.
    void advance(double smallStep);
    // Applies the changes of velocity and position to Bullet's body. The position must change too, or in the
    // next substep the cloth would find the solid at another position than it left it. If other solids touch
    // the body, its position is kept, because Bullet would move it out of them only slowly.
    void finish(btDispatcher* dispatcher);

    const btCollisionObject& object() const { return *object_; }
    const SolidPath& path() const { return path_; }
    bool isMovable() const { return response_.isMovable() && !isDriven_; }
    // Whether it neither moves nor can be pushed.
    bool isStill() const { return isStill_; }
    bool isTurning() const { return isTurning_; }

    // A vector of the solid, given as it is at the start of the substep, as it is now.
    btVector3 turned(const btVector3& atStart) const { return isTurning_ ? turn_ * atStart : atStart; }
    btVector3 unturned(const btVector3& now) const { return isTurning_ ? now * turn_ : now; }
    // Displacement of a point since the start of the substep.
    btVector3 displacement(const btVector3& arm) const {
        return isStill_ ? btVector3(0, 0, 0) : moved_ + (turned(arm) - arm) + shiftOf(arm);
    }
    // The part of it that impulses have caused.
    btVector3 shiftOf(const btVector3& arm) const {
        return shift_.linear + shift_.angular.cross(turned(arm));
    }
    // Displacement of that point in a small step.
    btVector3 step(const btVector3& arm) const {
        return (own_.linear + added_.linear + (own_.angular + added_.angular).cross(turned(arm))) *
               smallStep_;
    }
    // Its pose now, and at the start of the small step.
    btTransform pose() const { return poseAt(elapsed_, shift_); }
    btTransform poseBefore() const { return poseAt(elapsed_ - smallStep_, shiftBefore_); }

    // Cloth touches it, which keeps it awake.
    void touch() { isTouched_ = true; }
    // Response of that point to an impulse along a direction: an inverse mass, 1/kg.
    btScalar response(const btVector3& arm, const btVector3& direction) const;
    // Applies an impulse at that point.
    // @param push  impulse x small step of the world, kg m
    void push(const btVector3& arm, const btVector3& push);

  private:
    btTransform poseAt(btScalar time, const Twist& shift) const;

    btCollisionObject* object_;
    SolidPath path_;
    SolidResponse response_;
    Twist own_;                    // its own velocities, m/s and rad/s
    Twist added_;                  // velocities by impulses, m/s and rad/s
    Twist shift_, shiftBefore_;    // displacement by impulses, m and rad; at the start of the small step
    Wrench pushes_, displacing_;   // sums of impulses, N s, and of impulses times the time since, N s2
    btVector3 moved_ = {0, 0, 0};  // displacement of the centre of mass along the path, m
    btMatrix3x3 turn_ = btMatrix3x3::getIdentity();  // since the start of the substep
    bool isStill_ = true;
    bool isMoving_ = false, isTurning_ = false, isTouched_ = false, isDriven_ = false;
    btScalar substep_ = 0;    // s
    btScalar smallStep_ = 0;  // s
    btScalar elapsed_ = 0;    // s since the start of the substep
};

// The solids that sheets touch in a substep.
class Solids {
  public:
    void clear() { solids_.clear(); }
    // Index of a solid; it is added if it is new.
    std::size_t add(btCollisionObject& object, const SolidPath& path);
    Solid& operator[](std::size_t index) { return solids_[index]; }
    const Solid& operator[](std::size_t index) const { return solids_[index]; }

    void begin(double substep, const Motors& motors);
    void advance(double smallStep);
    void finish(btDispatcher* dispatcher);

  private:
    std::vector<Solid> solids_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
