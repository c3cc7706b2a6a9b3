// A plain Bullet world for soft bodies, as an application would set one up.
#pragma once

#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

namespace drench::demo {

/// Owns a world and the rigid bodies in it. Gravity is 9.81 m/s2 downwards (-y).
class BulletWorld {
  public:
    BulletWorld();
    ~BulletWorld();
    BulletWorld(const BulletWorld&) = delete;
    BulletWorld& operator=(const BulletWorld&) = delete;

    btSoftRigidDynamicsWorld& world() { return world_; }

    /// Level ground at a height: the top of a box, since soft bodies float above a plane shape.
    void addGround(double height);

    /// A ball; it stays where it is if its mass is 0.
    btRigidBody& addBall(const btVector3& centre, double radius, double mass);

    /// A box along the axes of the world that stays where it is.
    btRigidBody& addBox(const btVector3& centre, const btVector3& halfExtents);

    /// Steps the world by `frameTime`, in substeps of equal length.
    void step(double frameTime, int substeps);

  private:
    btRigidBody& add(std::unique_ptr<btCollisionShape> shape, const btVector3& position, double mass);

    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver constraintSolver_;
    btSoftRigidDynamicsWorld world_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace drench::demo
