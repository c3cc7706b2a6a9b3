// The solids that a sheet touches when Bullet solves its contacts, each looked up once per substep.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/contact/friction.h"
#include "bullet/contact/solid_distance.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

class MetSolids {
  public:
    struct Met {
        const btCollisionObject* object;
        bool exists;      // in the world with contact response; otherwise it must not be accessed
        Surface surface;  // towards the sheet
    };

    void begin(const btCollisionWorld& world, const btSoftBody& body, const Friction& sheetFriction);
    // @param object  only its address is used; it may have been destroyed. The result is valid until the next
    //     call
    const Met& at(const btCollisionObject* object);

  private:
    const btCollisionWorld* world_ = nullptr;
    const btSoftBody* body_ = nullptr;
    const Friction* sheetFriction_ = nullptr;
    std::vector<Met> met_;
    std::size_t last_ = 0;
};

// The nearest surface of a solid that is convex or consists of convex parts, from the distance field in which
// Bullet finds contacts; infinitely far for other shapes.
SurfacePoint nearestSurfaceOf(const btCollisionObject& solid, const btVector3& point, btSparseSdf<3>& field);

// Velocity of a solid at a position in the world, m/s.
btVector3 velocityAt(const btCollisionObject& solid, const btVector3& point);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
