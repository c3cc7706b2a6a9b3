// How a solid reacts to impulses: a rigid body, or a link of a btMultiBody.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

#include <vector>

#include "bullet/contact/rigid_motion.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// A force and a torque around the centre of mass, or an impulse and an angular impulse.
struct Wrench {
    btVector3 force = {0, 0, 0}, torque = {0, 0, 0};
};

// The linear relation between an impulse on a solid and the change of its motion. A link of a btMultiBody
// reacts as its whole articulated body does, with free joints: Bullet's motors and joint limits act in the
// next substep, as they do on rigid bodies. A link that is pushed while another link of the same body is
// pushed, too, feels that one from the next substep on.
class SolidResponse {
  public:
    // Reads it from Bullet. @pre Bullet has solved the substep
    explicit SolidResponse(const btCollisionObject& object);
    // Of a solid that nothing moves.
    SolidResponse() = default;

    bool isMovable() const { return isMovable_; }
    // Change of motion by an impulse.
    Twist to(const Wrench& impulse) const {
        Twist change = {impulse.force * linearFactor_ * inverseMass_,
                        inverseInertia_ * impulse.torque * angularFactor_};
        if (!isCoupled_) return change;
        change.linear += linear_ * impulse.force + coupling_ * impulse.torque;
        change.angular += impulse.force * coupling_;  // by the transposed matrix
        return change;
    }

    // Wakes a sleeping btMultiBody, which reacts from the next substep on. Rigid bodies react in their sleep.
    static void wake(btCollisionObject& object);

    // Applies an impulse to Bullet's body, and moves it.
    // @param push   impulse, N s
    // @param shift  impulse whose change of motion, m and rad, is added to the position; N s2
    static void apply(btCollisionObject& object, const Wrench& push, const Wrench* shift);

  private:
    void readRigidBody(const btCollisionObject& object);
    void readLink(const btCollisionObject& object);

    bool isMovable_ = false;
    bool isCoupled_ = false;  // whether the matrices below are not 0
    btScalar inverseMass_ = 0;
    btVector3 linearFactor_ = {1, 1, 1}, angularFactor_ = {1, 1, 1};  // of a rigid body
    btMatrix3x3 inverseInertia_ = btMatrix3x3(0, 0, 0, 0, 0, 0, 0, 0, 0);
    btMatrix3x3 linear_ = btMatrix3x3(0, 0, 0, 0, 0, 0, 0, 0, 0);    // of a link, from force to velocity
    btMatrix3x3 coupling_ = btMatrix3x3(0, 0, 0, 0, 0, 0, 0, 0, 0);  // from torque to velocity
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
