// Motion of rigid bodies: velocities, and the path of a substep.
#pragma once

#include <LinearMath/btTransform.h>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// A velocity of the centre of mass and an angular velocity; or a displacement, m, and a rotation vector, rad.
struct Twist {
    btVector3 linear = {0, 0, 0}, angular = {0, 0, 0};

    bool isZero() const { return linear.isZero() && angular.isZero(); }
    Twist operator*(btScalar factor) const { return {linear * factor, angular * factor}; }
};

// The rotation by a rotation vector, rad.
btMatrix3x3 rotation(const btVector3& vector);

// A pose after a displacement.
btTransform moved(const btTransform& pose, const Twist& by);

// The displacement from one pose to another, by the shorter rotation.
Twist displacementBetween(const btTransform& from, const btTransform& to);

// Where a solid is at the start and at the end of a substep. Both are poses of its centre of mass.
struct SolidPath {
    btTransform start, end;

    bool isMoving() const { return !(start == end); }
    // Displacement along it.
    Twist motion() const { return displacementBetween(start, end); }
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
