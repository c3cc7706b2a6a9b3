// What keeps the rain off: Bullet's rigid bodies.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>

#include "drench/config.h"
#include "drench/source.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Asks Bullet's ray test. Soft bodies, and things without contact response (triggers), keep nothing off.
class RigidShelter final : public Shelter {
  public:
    explicit RigidShelter(const btCollisionWorld& world) : world_(world) {}
    bool blocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const override;

  private:
    const btCollisionWorld& world_;
};

// What a ray to solid things hits first; soft bodies and triggers let it pass.
struct SolidRay final : btCollisionWorld::ClosestRayResultCallback {
    SolidRay(const btVector3& from, const btVector3& to);
    bool needsCollision(btBroadphaseProxy* proxy) const override;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
