// Bullet's deformable world for the tests, and sheets of 17 x 17 nodes in it.
#pragma once

#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>

#include <algorithm>
#include <memory>

#include "bullet/world/worlds.h"
#include "hanging_grid.h"

namespace drench::test {

constexpr int nodesAlongEdge = 17;
constexpr double side = 0.5;

enum class Mode { explicitSteps, implicitSteps };

// A deformable world as an application would set one up, with Bullet's own gravity force.
class DeformableWorld {
  public:
    explicit DeformableWorld(Mode mode, double fall = 9.81) : gravity_({0, btScalar(-fall), 0}) {
        constraints_.setDeformableSolver(&solver_);
        world_ = std::make_unique<btDeformableMultiBodyDynamicsWorld>(
            &dispatcher_, &broadphase_, &constraints_, &configuration_, &solver_);
        world_->setGravity(gravity_.m_gravity);
        world_->getWorldInfo().m_gravity = gravity_.m_gravity;
        world_->setImplicit(mode == Mode::implicitSteps);
        world_->setUseProjection(mode == Mode::implicitSteps);
    }
    ~DeformableWorld() { end(); }
    DeformableWorld(const DeformableWorld&) = delete;
    DeformableWorld& operator=(const DeformableWorld&) = delete;

    btDeformableMultiBodyDynamicsWorld& world() { return *world_; }
    btSoftBodyWorldInfo& info() { return world_->getWorldInfo(); }

    void add(btSoftBody& sheet) {
        world_->addSoftBody(&sheet);
        world_->addForce(&sheet, &gravity_);
    }
    btRigidBody& addBall(const btVector3& centre, double radius) {
        ballShape_ = std::make_unique<btSphereShape>(btScalar(radius));
        btRigidBody::btRigidBodyConstructionInfo settings(0, nullptr, ballShape_.get());
        settings.m_startWorldTransform.setIdentity();
        settings.m_startWorldTransform.setOrigin(centre);
        ball_ = std::make_unique<btRigidBody>(settings);
        world_->addRigidBody(ball_.get());
        return *ball_;
    }
    btDeformableLagrangianForce& wetForce() {
        auto& forces = *solver_.getLagrangianForceArray();
        return *forces[forces.size() - 1];
    }
    void step(double time, int substeps) {
        constexpr int variableStep = 0;
        for (int i = 0; i < substeps; ++i) world_->stepSimulation(btScalar(time / substeps), variableStep);
    }
    // Forces in the solver's list that are not Bullet's.
    int wetForces() {
        int count = 0;
        auto& forces = *solver_.getLagrangianForceArray();
        for (int i = 0; i < forces.size(); ++i)
            count += forces[i]->getForceType() > BT_MOUSE_PICKING_FORCE ? 1 : 0;
        return count;
    }
    // The world ends before the rest of this.
    void end() {
        if (ball_ && world_) world_->removeRigidBody(ball_.get());
        world_.reset();
    }

  private:
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btDeformableMultiBodyConstraintSolver constraints_;
    btDeformableBodySolver solver_;
    btDeformableGravityForce gravity_;
    std::unique_ptr<btDeformableMultiBodyDynamicsWorld> world_;
    std::unique_ptr<btCollisionShape> ballShape_;
    std::unique_ptr<btRigidBody> ball_;
};

// Largest substep that the test takes: the bound, or a frame where there is none.
inline double longestStep(const WetCloth& cloth) {
    return std::min(cloth.stepBound(), 1.0 / 60);
}

inline double largestExtension(const btSoftBody& sheet) {
    double largest = 0;
    for (int i = 0; i < sheet.m_links.size(); ++i) {
        const btSoftBody::Link& link = sheet.m_links[i];
        if (link.m_bbending) continue;
        largest = std::max(largest, double((link.m_n[1]->m_x - link.m_n[0]->m_x).length() / link.m_rl) - 1);
    }
    return largest;
}

inline bool hangsByCorners(int node) {
    return node < 2 || (node >= nodesAlongEdge - 2 && node < nodesAlongEdge);
}

inline void pinCorners(btSoftBody& sheet) {
    for (int n = 0; n < nodesAlongEdge; ++n)
        sheet.m_nodes[n].m_im = hangsByCorners(n) ? btScalar(0) : btScalar(1);
}

inline Outcome outcomeOf(const btSoftBody& sheet) {
    Outcome outcome{
        -side - double(sheet.m_nodes[nodesAlongEdge / 2 + nodesAlongEdge * (nodesAlongEdge - 1)].m_x.y()), 0};
    outcome.meanStrain = meanStrain(sheet);
    return outcome;
}

// Lets a sheet with `water` times its own mass of water come to rest.
inline Outcome inBullet(Mode mode, const Fabric& fabric, double water) {
    DeformableWorld bullet(mode);
    const auto sheet = hangingSheet(bullet.info(), fabric, side, nodesAlongEdge);
    pinCorners(*sheet);
    bullet.add(*sheet);
    SheetSettings settings;
    settings.waterSpeed = 0;  // the solver knows no water that runs down
    WetCloth cloth(bullet.world(), *sheet, fabric, settings);
    cloth.soakPores(water * fabric.arealDensity);
    constexpr double time = 2;
    const double dt = mode == Mode::implicitSteps ? 1.0 / 120 : cloth.stepBound();
    const int steps = static_cast<int>(std::ceil(time / dt));
    for (int i = 0; i < steps; ++i) {
        bullet.step(time / steps, 1);
        // Implicit steps know no m_cfg.drag.
        for (int n = 0; n < sheet->m_nodes.size(); ++n) sheet->m_nodes[n].m_v *= btScalar(1 - 10 * dt);
    }
    const Outcome outcome = outcomeOf(*sheet);
    bullet.world().removeSoftBody(sheet.get());
    return outcome;
}

// The same sheet put together from the textile formulas alone and solved at rest in double precision.
inline Outcome atRest(const Fabric& fabric, double water) {
    const auto problem =
        hangingGrid(fabric, side, nodesAlongEdge, fabric.arealDensity * (1 + water), hangsByCorners);
    const auto x = solveStatic(problem);
    return {-side - x[std::size_t(nodesAlongEdge / 2 + nodesAlongEdge * (nodesAlongEdge - 1))].y(),
            meanStrain(problem, x)};
}

}  // namespace drench::test
