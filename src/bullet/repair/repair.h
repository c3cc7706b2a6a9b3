// Puts right what an application, its forces or Bullet have left of a body that nobody can calculate with.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/repair/diagnostics.h"
#include "bullet/sheet/rest_shape.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Mends the settings of m_cfg: those that are out of range get Bullet's default.
void repairSettings(btSoftBody& body, Diagnostics& diagnostics);

// The same for the rest length scale. @pre the body is of that shape
void repairRestLengthScale(btSoftBody& body, const RestShape& shape, Diagnostics& diagnostics);

// Mends the gravity of the body's world info. @param lastGood  what it becomes, m/s2
void repairGravity(btSoftBody& body, const btVector3& lastGood, Diagnostics& diagnostics);

// Mends positions, velocities, forces and inverse masses.
// @param lastGood  of each node the last good place, m; a node beyond these goes where one is that it is linked to
// @param masses    of each node, kg; one beyond these becomes a pin
void repairNodes(btSoftBody& body, const std::vector<btVector3>& lastGood, const std::vector<double>& masses,
                 Diagnostics& diagnostics);

// Where the nodes of a body are, m.
std::vector<btVector3> positionsOf(const btSoftBody& body);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
