// Shelter from rain by Bullet's rigid bodies.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>

#include "drench/config.h"
#include "drench/source.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Uses Bullet's ray test. Soft bodies, and objects without contact response (triggers), give no shelter.
class RigidShelter final : public Shelter {
  public:
    explicit RigidShelter(const btCollisionWorld& world) : world_(world) {}
    bool blocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const override;

  private:
    const btCollisionWorld& world_;
};

// The first solid that a ray hits; soft bodies and triggers are ignored.
struct SolidRay final : btCollisionWorld::ClosestRayResultCallback {
    SolidRay(const btVector3& from, const btVector3& to);
    bool needsCollision(btBroadphaseProxy* proxy) const override;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
