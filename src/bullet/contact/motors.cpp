#include "bullet/contact/motors.h"

#include <BulletDynamics/Featherstone/btMultiBodyConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <algorithm>
#include <functional>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

bool isMotor(const btMultiBodyConstraint& constraint) {
    const int type = constraint.getConstraintType();
    return (type == MULTIBODY_CONSTRAINT_1DOF_JOINT_MOTOR || type == MULTIBODY_CONSTRAINT_SPHERICAL_MOTOR) &&
           constraint.getMaxAppliedImpulse() > 0;
}

}  // namespace

void Motors::read(const btDiscreteDynamicsWorld& world) {
    driven_.clear();
    if (world.getWorldType() != BT_SOFT_MULTIBODY_DYNAMICS_WORLD) return;
    // Bullet has no const access.
    auto& multiBodies = static_cast<btMultiBodyDynamicsWorld&>(const_cast<btDiscreteDynamicsWorld&>(world));
    for (int i = 0; i < multiBodies.getNumMultiBodyConstraints(); ++i) {
        btMultiBodyConstraint& constraint = *multiBodies.getMultiBodyConstraint(i);
        if (isMotor(constraint)) driven_.push_back(constraint.getMultiBodyA());
    }
    std::sort(driven_.begin(), driven_.end(), std::less<>());
}

bool Motors::drive(const btCollisionObject& object) const {
    const btMultiBodyLinkCollider* const link = btMultiBodyLinkCollider::upcast(&object);
    return link && std::binary_search(driven_.begin(), driven_.end(), link->m_multiBody, std::less<>());
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
