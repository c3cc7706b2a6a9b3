// Rays that end on what is solid.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>

namespace drench::demo {

/// What a ray to solid things hits first, for `btCollisionWorld::rayTest`; soft bodies and triggers let it pass.
struct SolidRay final : btCollisionWorld::ClosestRayResultCallback {
    SolidRay(const btVector3& from, const btVector3& to) : ClosestRayResultCallback(from, to) {
        // Bullet's default ray misses a convex body that is less than a centimetre away.
        m_flags |= btTriangleRaycastCallback::kF_UseGjkConvexCastRaytest;
    }
    bool needsCollision(btBroadphaseProxy* proxy) const override {
        const auto* const object = static_cast<const btCollisionObject*>(proxy->m_clientObject);
        return object->getInternalType() != btCollisionObject::CO_SOFT_BODY && object->hasContactResponse() &&
               ClosestRayResultCallback::needsCollision(proxy);
    }
};

}  // namespace drench::demo
