// What a layer refuses to attach to, and why.
#pragma once

#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <Eigen/Core>
#include <vector>

#include "drench/precision.h"
#include "rest_shape.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// Refuses a body that is no cloth: no faces or links, clusters, tetrahedra, positions that are not finite.
/// @throws std::invalid_argument
void checkBody(const btSoftBody& body);

/// Refuses a world in which the body cannot touch things where they are: a distance field or margin coarser
/// than the mean link, or a plane shape that the body would float above.
/// @throws std::invalid_argument
void checkWorld(btSoftRigidDynamicsWorld& world, const btSoftBody& body, const RestShape& shape);

/// Refuses two faces of the same nodes, and two links of the same nodes: each would count twice.
/// @throws std::invalid_argument
void checkDuplicates(const RestShape& shape);

/// Refuses links of no length, and material coordinates that are not one finite pair a node or in which a
/// triangle has less than a third or more than three times its area.
/// @throws std::invalid_argument
void checkShape(const RestShape& shape, const std::vector<Eigen::Vector2d>& materialCoordinates);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
