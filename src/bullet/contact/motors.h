// Which multibodies motors drive.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>

#include <vector>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Bullet's motors hold the velocity of joints, not their place. What cloth displaces them by in each substep would never
// come back: a gripper that carries wet cloth would sink.
class Motors {
  public:
    // Reads the constraints of a world.
    void read(const btDiscreteDynamicsWorld& world);
    // Whether the object is of a multibody with a joint that a motor drives.
    bool drive(const btCollisionObject& object) const;

  private:
    std::vector<const btMultiBody*> driven_;  // sorted
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
