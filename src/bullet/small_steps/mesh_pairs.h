// Keeps Bullet from searching the triangles of solids for sheets that find them themselves.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <BulletSoftBody/btSoftBody.h>

#include <memory>
#include <set>

#include "drench/config.h"

class btCollisionAlgorithm;

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// For each triangle near a soft body Bullet keeps a convex hull and reports it by itself; for a fine mesh that takes
// longer than the whole step of a sheet. Here one report per solid suffices. So each pair of a sheet and a solid that is
// not convex gets a collision algorithm that reports the solid once, and leaves everything else to Bullet's own
// algorithm: other bodies, and sheets that small steps do not move.
class MeshPairs {
  public:
    // Whether small steps move a body now.
    using IsMoved = bool (*)(btSoftBody& body);

    explicit MeshPairs(IsMoved isMoved);
    // Gives all pairs of moved bodies that have come since then their algorithm.
    void update(btBroadphaseInterface& broadphase, btDispatcher& dispatcher);

  private:
    class Algorithm;
    struct Known {
        IsMoved isMoved;
        std::set<const btCollisionAlgorithm*> algorithms;
    };
    std::shared_ptr<Known> known_;  // of all algorithms, which may outlive this
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
