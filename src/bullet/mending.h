// Puts right what an application, its forces or Bullet have left of a body that nobody can calculate with.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include "drench/precision.h"
#include "pose.h"
#include "sheet_mechanics.h"
#include "troubles.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// What a sheet may have at most; beyond that single precision, and Bullet's trees, come to no good.
constexpr double farthestPlace = 1e9;     // m, along an axis
constexpr double fastestNode = 1e6;       // m/s, along an axis
constexpr double strongestGravity = 1e4;  // m/s2

/// Mends the settings of m_cfg and the rest length scale: those that are out of range get Bullet's default.
void mendSettings(btSoftBody& body, const RestShape& shape, Troubles& troubles);

/// Mends the gravity of the body's world info. @param lastGood  what it becomes, m/s2
void mendGravity(btSoftBody& body, const btVector3& lastGood, Troubles& troubles);

/// Mends positions, velocities, forces and inverse masses.
/// @param lastGood  knows the last good places
void mendNodes(btSoftBody& body, const Pose& lastGood, const SheetMechanics& mechanics, Troubles& troubles);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
