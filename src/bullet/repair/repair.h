// Repairs invalid values of a body, such as NaN, that come from the application, its forces or Bullet.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/repair/diagnostics.h"
#include "bullet/sheet/rest_shape.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Repairs the settings in m_cfg: values out of range are set to Bullet's default.
void repairSettings(btSoftBody& body, Diagnostics& diagnostics);

// The same for the rest length scale. @pre the topology of the body is that of the shape
void repairRestLengthScale(btSoftBody& body, const RestShape& shape, Diagnostics& diagnostics);

// Repairs the gravity of the body's world info. @param lastGood  value to which it is reset, m/s2
void repairGravity(btSoftBody& body, const btVector3& lastGood, Diagnostics& diagnostics);

// Repairs positions, velocities, forces and inverse masses.
// @param lastGood  last valid position of each node, m; a node beyond this list is moved to a node to which
//     it is linked
// @param masses    of each node, kg; a node beyond this list is pinned
void repairNodes(btSoftBody& body, const std::vector<btVector3>& lastGood, const std::vector<double>& masses,
                 Diagnostics& diagnostics);

// Positions of the nodes of a body, m.
std::vector<btVector3> positionsOf(const btSoftBody& body);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
