// Bullet's deformable world.
#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>

#include <memory>

#include "world/scene_world.h"

namespace drench::demo {

// In explicit steps, which are stable in contact.
class DeformableWorld final : public SceneWorld {
  public:
    DeformableWorld();
    ~DeformableWorld() override;
    DeformableWorld(const DeformableWorld&) = delete;
    DeformableWorld& operator=(const DeformableWorld&) = delete;

    btDeformableMultiBodyDynamicsWorld& world() override { return *world_; }
    btSoftBodyWorldInfo& worldInfo() override { return world_->getWorldInfo(); }
    void addSoftBody(btSoftBody& body) override;
    void removeSoftBody(btSoftBody& body) override { world_->removeSoftBody(&body); }

    // As many as the bound requires, even above `max`, because longer steps are unstable.
    int substepsFor(double frameTime, double stepBound, int max) const override;
    void damp(btSoftBody& sheet, double rate, double substep) const override;
    std::string stepsName() const override;

  private:
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btDeformableMultiBodyConstraintSolver constraintSolver_;
    btDeformableBodySolver bodySolver_;
    btDeformableGravityForce gravity_;
    std::unique_ptr<btDeformableMultiBodyDynamicsWorld> world_;
};

}  // namespace drench::demo
