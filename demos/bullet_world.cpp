#include "bullet_world.h"

namespace drench::demo {

BulletWorld::BulletWorld()
    : dispatcher_(&configuration_), world_(&dispatcher_, &broadphase_, &constraintSolver_, &configuration_) {
    const btVector3 gravity(0, btScalar(-9.81), 0);
    world_.setGravity(gravity);
    world_.getWorldInfo().m_gravity = gravity;  // soft bodies have their own
}

BulletWorld::~BulletWorld() {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
}

void BulletWorld::addGround(double height) {
    constexpr double thickness = 2;
    const btVector3 halfExtents(50, btScalar(thickness / 2), 50);
    add(std::make_unique<btBoxShape>(halfExtents), {0, btScalar(height - thickness / 2), 0}, 0);
}

btRigidBody& BulletWorld::addBall(const btVector3& centre, double radius, double mass) {
    return add(std::make_unique<btSphereShape>(btScalar(radius)), centre, mass);
}

btRigidBody& BulletWorld::addBox(const btVector3& centre, const btVector3& halfExtents) {
    return add(std::make_unique<btBoxShape>(halfExtents), centre, 0);
}

btRigidBody& BulletWorld::add(std::unique_ptr<btCollisionShape> shape, const btVector3& position,
                              double mass) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape->calculateLocalInertia(btScalar(mass), inertia);
    btRigidBody::btRigidBodyConstructionInfo info(btScalar(mass), nullptr, shape.get(), inertia);
    info.m_startWorldTransform = btTransform(btQuaternion::getIdentity(), position);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    shapes_.push_back(std::move(shape));
    world_.addRigidBody(bodies_.back().get());
    return *bodies_.back();
}

void BulletWorld::step(double frameTime, int substeps) {
    const btScalar substep = btScalar(frameTime / substeps);
    constexpr int variableStep = 0;
    for (int i = 0; i < substeps; ++i) world_.stepSimulation(substep, variableStep);
}

}  // namespace drench::demo
