// The worlds that move soft bodies, and what differs between them. Told apart by getWorldType, as Bullet may
// have been built without RTTI.
#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletSoftBody/btSoftBody.h>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// The same world. @throws std::invalid_argument if it is none that moves soft bodies
btDiscreteDynamicsWorld& checkedSoftWorld(btDiscreteDynamicsWorld& world);

// Whether it is Bullet's deformable world.
bool isDeformable(const btDiscreteDynamicsWorld& world);

// Its soft bodies. @pre the world is a checked one
const btAlignedObjectArray<btSoftBody*>& softBodiesOf(btDiscreteDynamicsWorld& world);

// What its soft bodies share. @pre the world is a checked one
const btSoftBodyWorldInfo& worldInfoOf(btDiscreteDynamicsWorld& world);

// How a deformable world integrates.
struct DeformableMode {
    bool implicit;       // setImplicit
    bool useProjection;  // setUseProjection
};
// @pre the world is deformable
DeformableMode deformableModeOf(const btDiscreteDynamicsWorld& world);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
