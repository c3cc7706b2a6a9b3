// The solids that a sheet meets where Bullet solves its contacts, looked up once a substep each.
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
        bool exists;      // and has contacts; else the object is not to be touched
        Surface surface;  // to the sheet
    };

    void begin(const btCollisionWorld& world, const btSoftBody& body, const Friction& sheetFriction);
    // @param object  by its address; it may be gone. The answer is good until the next is asked for
    const Met& at(const btCollisionObject* object);

  private:
    const btCollisionWorld* world_ = nullptr;
    const btSoftBody* body_ = nullptr;
    const Friction* sheetFriction_ = nullptr;
    std::vector<Met> met_;
    std::size_t last_ = 0;
};

// The nearest surface of a solid that is convex or made of convex parts, by the distance field in which Bullet
// finds contacts; infinitely far for others.
SurfacePoint nearestSurfaceOf(const btCollisionObject& solid, const btVector3& point, btSparseSdf<3>& field);

// Velocity of a solid at a place in the world, m/s.
btVector3 velocityAt(const btCollisionObject& solid, const btVector3& point);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
