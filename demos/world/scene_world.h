// Worlds for scenes, and their common functions.
#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletSoftBody/btSoftBody.h>
#include <drench/small_step_solver.h>

#include <memory>
#include <string>
#include <vector>

#include "world/world_kind.h"

namespace drench::demo {

// A world as an application would make it; owns its rigid bodies. Gravity is 9.81 m/s2 downwards (-y).
class SceneWorld {
  public:
    virtual ~SceneWorld() = default;
    SceneWorld(const SceneWorld&) = delete;
    SceneWorld& operator=(const SceneWorld&) = delete;

    virtual btDiscreteDynamicsWorld& world() = 0;
    virtual btSoftBodyWorldInfo& worldInfo() = 0;
    virtual void addSoftBody(btSoftBody& body) = 0;
    virtual void removeSoftBody(btSoftBody& body) = 0;

    // Number of substeps that a frame needs for sheets with this step bound (WetCloth::stepBound), s; at most
    // `max` if longer substeps would only make links softer.
    virtual int substepsFor(double frameTime, double stepBound, int max) const = 0;
    // Sets the decay rate of a sheet's velocity, 1/s, for substeps of the given length, s.
    virtual void damp(btSoftBody& sheet, double rate, double substep) const = 0;
    // Number of small steps of the last substep; 0 without a SmallStepSolver.
    virtual int smallSteps() const { return 0; }
    // Number of steps of the sheets in the last frame, for the given number of substeps.
    int stepsOfFrame(int substeps) const { return smallSteps() > 0 ? smallSteps() : substeps; }
    // Description of the steps of a frame, for a report: "Substeps per frame ...".
    virtual std::string stepsName() const = 0;

    // Horizontal ground: the top of a box, because soft bodies float above plane shapes.
    btRigidBody& addGround(double height);

    // A ball; static if its mass is 0.
    btRigidBody& addBall(const btVector3& centre, double radius, double mass);

    // A box, axis-aligned or rotated; static if its mass is 0.
    btRigidBody& addBox(const btVector3& centre, const btVector3& halfExtents,
                        const btQuaternion& turn = btQuaternion::getIdentity(), double mass = 0);

    // A capsule along its own y axis; static if its mass is 0.
    // @param length  between the centres of its ends, m
    btRigidBody& addCapsule(const btVector3& centre, double radius, double length, const btQuaternion& turn,
                            double mass = 0);

    // Steps the world by `frameTime`, in substeps of equal length.
    void step(double frameTime, int substeps);

  protected:
    SceneWorld() = default;

  private:
    btRigidBody& add(std::unique_ptr<btCollisionShape> shape, const btTransform& transform, double mass);

    // Rigid bodies, which outlive the world in the derived classes.
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

// Mean |length / rest length - 1| of the stretch and shear links of a body.
double meanStrain(const btSoftBody& body);

// An empty world. @param solver, steps  used only in a soft-rigid world
std::unique_ptr<SceneWorld> makeWorld(WorldKind kind, SolverKind solver, const SmallStepSettings& steps = {});

}  // namespace drench::demo
