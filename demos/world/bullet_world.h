// Bullet's plain world for soft bodies.
#pragma once

#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include "world/scene_world.h"

namespace drench::demo {

class BulletWorld : public SceneWorld {
  public:
    /// @param solver  of the soft bodies, which must outlive this; none: Bullet's own
    explicit BulletWorld(btSoftBodySolver* solver = nullptr);

    btSoftRigidDynamicsWorld& world() override { return world_; }
    btSoftBodyWorldInfo& worldInfo() override { return world_.getWorldInfo(); }
    void addSoftBody(btSoftBody& body) override { world_.addSoftBody(&body); }
    void removeSoftBody(btSoftBody& body) override { world_.removeSoftBody(&body); }

    int substepsFor(double frameTime, double stepBound, int most) const override;
    void damp(btSoftBody& sheet, double rate, double substep) const override;
    std::string stepsName() const override;

  private:
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver constraintSolver_;
    btSoftRigidDynamicsWorld world_;
};

}  // namespace drench::demo
