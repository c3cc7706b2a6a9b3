// The worlds that scenes run in, and what they share.
#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletSoftBody/btSoftBody.h>
#include <drench/small_step_solver.h>

#include <memory>
#include <string>
#include <vector>

#include "world/world_kind.h"

namespace drench::demo {

// A world as an application would set one up; owns the rigid bodies in it. Gravity is 9.81 m/s2 downwards (-y).
class SceneWorld {
  public:
    virtual ~SceneWorld() = default;
    SceneWorld(const SceneWorld&) = delete;
    SceneWorld& operator=(const SceneWorld&) = delete;

    virtual btDiscreteDynamicsWorld& world() = 0;
    virtual btSoftBodyWorldInfo& worldInfo() = 0;
    virtual void addSoftBody(btSoftBody& body) = 0;
    virtual void removeSoftBody(btSoftBody& body) = 0;

    // Substeps that a frame needs for sheets with this step bound (WetCloth::stepBound), s; `most` where fewer
    // would only make links softer.
    virtual int substepsFor(double frameTime, double stepBound, int max) const = 0;
    // Has a sheet lose its velocity at a rate, 1/s, in substeps of so many seconds.
    virtual void damp(btSoftBody& sheet, double rate, double substep) const = 0;
    // Small steps that the solver made of the last substep; 0 where it makes none.
    virtual int smallSteps() const { return 0; }
    // Steps in which the sheets moved in the last frame, which had so many substeps.
    int stepsOfFrame(int substeps) const { return smallSteps() > 0 ? smallSteps() : substeps; }
    // What the steps of a frame are, for a report: "Substeps per frame ...".
    virtual std::string stepsName() const = 0;

    // Level ground at a height: the top of a box, since soft bodies float above a plane shape.
    btRigidBody& addGround(double height);

    // A ball; it stays where it is if its mass is 0.
    btRigidBody& addBall(const btVector3& centre, double radius, double mass);

    // A box, along the axes of the world or turned; it stays where it is if its mass is 0.
    btRigidBody& addBox(const btVector3& centre, const btVector3& halfExtents,
                        const btQuaternion& turn = btQuaternion::getIdentity(), double mass = 0);

    // A rod with round ends along its own y axis; it stays where it is if its mass is 0.
    // @param length  between the centres of its ends, m
    btRigidBody& addCapsule(const btVector3& centre, double radius, double length, const btQuaternion& turn,
                            double mass = 0);

    // Steps the world by `frameTime`, in substeps of equal length.
    void step(double frameTime, int substeps);

  protected:
    SceneWorld() = default;

  private:
    btRigidBody& add(std::unique_ptr<btCollisionShape> shape, const btTransform& transform, double mass);

    // They outlive the world, which is a member of the classes derived from this.
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

// Of a body's stretch and shear links, the mean of |length / rest length - 1|.
double meanStrain(const btSoftBody& body);

// An empty world. @param solver, steps  count in a soft-rigid world only
std::unique_ptr<SceneWorld> makeWorld(WorldKind kind, SolverKind solver, const SmallStepSettings& steps = {});

}  // namespace drench::demo
