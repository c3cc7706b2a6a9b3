#include "world/scene_world.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include <cmath>

#include "world/bullet_world.h"
#include "world/deformable_world.h"

namespace drench::demo {

btRigidBody& SceneWorld::addGround(double height) {
    constexpr double thickness = 2;
    return addBox({0, btScalar(height - thickness / 2), 0}, {50, btScalar(thickness / 2), 50});
}

btRigidBody& SceneWorld::addBall(const btVector3& centre, double radius, double mass) {
    return add(std::make_unique<btSphereShape>(btScalar(radius)),
               btTransform(btQuaternion::getIdentity(), centre), mass);
}

btRigidBody& SceneWorld::addBox(const btVector3& centre, const btVector3& halfExtents,
                                const btQuaternion& turn, double mass) {
    return add(std::make_unique<btBoxShape>(halfExtents), btTransform(turn, centre), mass);
}

btRigidBody& SceneWorld::addCapsule(const btVector3& centre, double radius, double length,
                                    const btQuaternion& turn, double mass) {
    return add(std::make_unique<btCapsuleShape>(btScalar(radius), btScalar(length)),
               btTransform(turn, centre), mass);
}

btRigidBody& SceneWorld::add(std::unique_ptr<btCollisionShape> shape, const btTransform& transform,
                             double mass) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape->calculateLocalInertia(btScalar(mass), inertia);
    btRigidBody::btRigidBodyConstructionInfo info(btScalar(mass), nullptr, shape.get(), inertia);
    info.m_startWorldTransform = transform;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    shapes_.push_back(std::move(shape));
    world().addRigidBody(bodies_.back().get());
    return *bodies_.back();
}

void SceneWorld::step(double frameTime, int substeps) {
    const btScalar substep = btScalar(frameTime / substeps);
    constexpr int variableStep = 0;
    for (int i = 0; i < substeps; ++i) world().stepSimulation(substep, variableStep);
}

std::unique_ptr<SceneWorld> makeWorld(WorldKind kind, SolverKind solver, const SmallStepSettings& steps) {
    if (kind == WorldKind::deformable) return std::make_unique<DeformableWorld>();
    if (solver == SolverKind::smallStep) return std::make_unique<SmallStepWorld>(steps);
    return std::make_unique<BulletWorld>();
}

double meanStrain(const btSoftBody& body) {
    double sum = 0;
    int counted = 0;
    for (int i = 0; i < body.m_links.size(); ++i) {
        const btSoftBody::Link& link = body.m_links[i];
        if (link.m_bbending) continue;
        sum += std::abs(double((link.m_n[1]->m_x - link.m_n[0]->m_x).length() / link.m_rl) - 1);
        ++counted;
    }
    return sum / counted;
}

}  // namespace drench::demo
