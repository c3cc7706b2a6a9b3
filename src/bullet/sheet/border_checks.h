// What a layer refuses to attach to, and why.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletSoftBody/btSoftBody.h>

#include "bullet/sheet/rest_shape.h"
#include "drench/cloth_mesh.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Refuses a body that is no cloth: no faces or links, clusters, tetrahedra, positions that are not finite.
// @throws std::invalid_argument
void checkBody(const btSoftBody& body);

// Refuses a world with a plane shape that the body could meet, and would float above.
// @throws std::invalid_argument
void checkPlanes(const btCollisionWorld& world, const btSoftBody& body);

// Refuses a body that cannot touch things where they are: with a distance field or a margin coarser than its
// mean link.
// @throws std::invalid_argument
void checkContacts(const btSoftBody& body, const RestShape& shape);

// Refuses two faces of the same nodes, and two links of the same nodes: each would count twice.
// @throws std::invalid_argument
void checkDuplicates(const RestShape& shape);

// Refuses links of no length, faces of no area, and material coordinates that are not finite or in which a
// triangle has less than a third or more than three times its area.
// @throws std::invalid_argument
void checkShape(const RestShape& shape, const ClothMesh& mesh);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
