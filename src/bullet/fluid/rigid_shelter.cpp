#include "bullet/fluid/rigid_shelter.h"

#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>

#include "bullet/world/vectors.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

SolidRay::SolidRay(const btVector3& from, const btVector3& to) : ClosestRayResultCallback(from, to) {
    // Bullet's default ray misses a convex body that is less than a centimetre away.
    m_flags |= btTriangleRaycastCallback::kF_UseGjkConvexCastRaytest;
}

bool SolidRay::needsCollision(btBroadphaseProxy* proxy) const {
    const auto* object = static_cast<const btCollisionObject*>(proxy->m_clientObject);
    return object->getInternalType() != btCollisionObject::CO_SOFT_BODY && object->hasContactResponse() &&
           ClosestRayResultCallback::needsCollision(proxy);
}

bool RigidShelter::blocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    SolidRay ray(toBullet(from), toBullet(to));
    world_.rayTest(ray.m_rayFromWorld, ray.m_rayToWorld, ray);
    return ray.hasHit();
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
