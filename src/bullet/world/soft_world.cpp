#include "bullet/world/soft_world.h"

#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include "checks/checks.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

using DeformableFlag = bool btDeformableMultiBodyDynamicsWorld::*;

using DeformableSolver = btDeformableBodySolver* btDeformableMultiBodyDynamicsWorld::*;

// Bullet has setImplicit and setUseProjection but no getters, none for its solver of soft bodies, and a derived
// class has no access either. An explicit template instantiation may name private members, and makes them
// accessible through a friend.
DeformableFlag implicitFlag();
DeformableFlag projectionFlag();
DeformableSolver solverMember();
template <DeformableFlag implicit, DeformableFlag projection, DeformableSolver solver>
struct Revealed {
    friend DeformableFlag implicitFlag() { return implicit; }
    friend DeformableFlag projectionFlag() { return projection; }
    friend DeformableSolver solverMember() { return solver; }
};
template struct Revealed<&btDeformableMultiBodyDynamicsWorld::m_implicit,
                         &btDeformableMultiBodyDynamicsWorld::m_useProjection,
                         &btDeformableMultiBodyDynamicsWorld::m_deformableBodySolver>;

// Calls `use` with the world cast to its class.
template <typename Use>
decltype(auto) withSoftWorld(btDiscreteDynamicsWorld& world, Use use) {
    switch (world.getWorldType()) {
        case BT_SOFT_RIGID_DYNAMICS_WORLD:
            return use(static_cast<btSoftRigidDynamicsWorld&>(world));
        case BT_SOFT_MULTIBODY_DYNAMICS_WORLD:
            return use(static_cast<btSoftMultiBodyDynamicsWorld&>(world));
        case BT_DEFORMABLE_MULTIBODY_DYNAMICS_WORLD:
            return use(static_cast<btDeformableMultiBodyDynamicsWorld&>(world));
        default:
            refuse("a world of type ", static_cast<int>(world.getWorldType()),
                   " has no soft bodies; give a btSoftRigidDynamicsWorld, "
                   "btSoftMultiBodyDynamicsWorld or btDeformableMultiBodyDynamicsWorld");
    }
}

}  // namespace

btDiscreteDynamicsWorld& checkedSoftWorld(btDiscreteDynamicsWorld& world) {
    return withSoftWorld(world, [](auto& known) -> btDiscreteDynamicsWorld& { return known; });
}

bool isDeformable(const btDiscreteDynamicsWorld& world) {
    return world.getWorldType() == BT_DEFORMABLE_MULTIBODY_DYNAMICS_WORLD;
}

const btAlignedObjectArray<btSoftBody*>& softBodiesOf(btDiscreteDynamicsWorld& world) {
    return withSoftWorld(world, [](auto& known) -> const btAlignedObjectArray<btSoftBody*>& {
        return known.getSoftBodyArray();
    });
}

bool meetsSoftBodies(btDiscreteDynamicsWorld& world, const btSoftBody& body) {
    const auto& all = softBodiesOf(world);
    for (int i = 0; i < all.size(); ++i)
        if (all[i] != &body &&
            (all[i]->m_cfg.collisions & body.m_cfg.collisions & btSoftBody::fCollision::VF_SS))
            return true;
    return false;
}

const btSoftBodyWorldInfo& worldInfoOf(btDiscreteDynamicsWorld& world) {
    return withSoftWorld(world,
                         [](auto& known) -> const btSoftBodyWorldInfo& { return known.getWorldInfo(); });
}

DeformableMode deformableModeOf(const btDiscreteDynamicsWorld& world) {
    const auto& deformable = static_cast<const btDeformableMultiBodyDynamicsWorld&>(world);
    return {deformable.*implicitFlag(), deformable.*projectionFlag()};
}

btDeformableBodySolver& deformableSolverOf(btDiscreteDynamicsWorld& world) {
    return *(static_cast<btDeformableMultiBodyDynamicsWorld&>(world).*solverMember());
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
