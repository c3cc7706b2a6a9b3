#include "bullet/contact/rigid_motion.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// The rotation vector of a rotation, rad. Bullet's own function takes the angle from its cosine, which for
// small angles is noise.
btVector3 rotationVector(const btMatrix3x3& turn) {
    const btVector3 twice(turn[2][1] - turn[1][2], turn[0][2] - turn[2][0], turn[1][0] - turn[0][1]);
    const btScalar sine = twice.length() / 2;
    const btScalar cosine = (turn[0][0] + turn[1][1] + turn[2][2] - 1) / 2;
    if (sine > SIMD_EPSILON) return twice * (btAtan2(sine, cosine) / (2 * sine));
    if (cosine > 0) return {0, 0, 0};
    btQuaternion half;  // a turn of 180 degrees, around either direction of its axis
    turn.getRotation(half);
    return half.getAxis() * SIMD_PI;
}

}  // namespace

btMatrix3x3 rotation(const btVector3& vector) {
    const btScalar angle = vector.length();
    return angle > 0 ? btMatrix3x3(btQuaternion(vector / angle, angle)) : btMatrix3x3::getIdentity();
}

btTransform moved(const btTransform& pose, const Twist& by) {
    return btTransform(rotation(by.angular) * pose.getBasis(), pose.getOrigin() + by.linear);
}

Twist displacementBetween(const btTransform& from, const btTransform& to) {
    Twist displacement = {to.getOrigin() - from.getOrigin(), {0, 0, 0}};
    if (!(from.getBasis() == to.getBasis()))
        displacement.angular = rotationVector(to.getBasis() * from.getBasis().transpose());
    return displacement;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
