// Bullet's worlds for soft bodies, and their differences. Recognised by getWorldType, because Bullet may have
// been built without RTTI.
#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletSoftBody/btSoftBody.h>

#include "drench/config.h"

class btDeformableBodySolver;

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// The same world. @throws std::invalid_argument for a world without soft bodies
btDiscreteDynamicsWorld& checkedSoftWorld(btDiscreteDynamicsWorld& world);

// Whether it is Bullet's deformable world.
bool isDeformable(const btDiscreteDynamicsWorld& world);

// Its soft bodies. @pre the world has been checked
const btAlignedObjectArray<btSoftBody*>& softBodiesOf(btDiscreteDynamicsWorld& world);

// Whether Bullet may search for contacts of a body with another soft body. @pre the world has been checked
bool meetsSoftBodies(btDiscreteDynamicsWorld& world, const btSoftBody& body);

// The world info of its soft bodies. @pre the world has been checked
const btSoftBodyWorldInfo& worldInfoOf(btDiscreteDynamicsWorld& world);

// How a deformable world integrates.
struct DeformableMode {
    bool implicit;       // setImplicit
    bool useProjection;  // setUseProjection
};
// @pre the world is deformable
DeformableMode deformableModeOf(const btDiscreteDynamicsWorld& world);
// Its solver of soft bodies. @pre the world is deformable
btDeformableBodySolver& deformableSolverOf(btDiscreteDynamicsWorld& world);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
