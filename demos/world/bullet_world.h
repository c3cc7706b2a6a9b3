// Bullet's soft-rigid world, with the stock solver or Drench's.
#pragma once

#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include "world/scene_world.h"

namespace drench::demo {

// A soft-rigid world with the stock solver or a given one.
class BulletWorld : public SceneWorld {
  public:
    // @param solver  of the soft bodies; must outlive this; null: the stock solver
    explicit BulletWorld(btSoftBodySolver* solver = nullptr);

    btSoftRigidDynamicsWorld& world() override { return world_; }
    btSoftBodyWorldInfo& worldInfo() override { return world_.getWorldInfo(); }
    void addSoftBody(btSoftBody& body) override { world_.addSoftBody(&body); }
    void removeSoftBody(btSoftBody& body) override { world_.removeSoftBody(&body); }

    int substepsFor(double frameTime, double stepBound, int max) const override;
    void damp(btSoftBody& sheet, double rate, double substep) const override;
    std::string stepsName() const override;

  private:
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver constraintSolver_;
    btSoftRigidDynamicsWorld world_;
};

// Base class, so that the solver is made before the world and destroyed after it.
class OwnSolver {
  protected:
    explicit OwnSolver(const SmallStepSettings& settings) : solver_(settings) {}
    SmallStepSolver solver_;
};

// With a SmallStepSolver.
class SmallStepWorld final : private OwnSolver, public BulletWorld {
  public:
    explicit SmallStepWorld(const SmallStepSettings& settings) : OwnSolver(settings), BulletWorld(&solver_) {}

    // One substep: the solver divides it into small steps.
    int substepsFor(double, double, int) const override { return 1; }
    // The solver uses kDP as a rate.
    void damp(btSoftBody& sheet, double rate, double) const override { sheet.m_cfg.kDP = btScalar(rate); }
    int smallSteps() const override { return solver_.steps(); }
    std::string stepsName() const override { return "Small steps per frame of 1/60 s, in one substep"; }
};

}  // namespace drench::demo
