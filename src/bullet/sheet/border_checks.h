// Checks of a body and a world before a layer attaches.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletSoftBody/btSoftBody.h>

#include "bullet/sheet/rest_shape.h"
#include "drench/cloth_mesh.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Refuses a body that is not a valid cloth: no faces or links, clusters, tetrahedra, positions that are not
// finite.
// @throws std::invalid_argument
void checkBody(const btSoftBody& body);

// Refuses a world with a plane shape that the body could collide with, because cloth floats above planes.
// @throws std::invalid_argument
void checkPlanes(const btCollisionWorld& world, const btSoftBody& body);

// Mean rest length of the links that are not for bending, m. @pre there are links
double meanLinkLength(const RestShape& shape);

// Refuses a body whose contacts would be inaccurate: a distance field or a margin coarser than its mean link.
// @throws std::invalid_argument
void checkContacts(const btSoftBody& body, const RestShape& shape);

// Refuses duplicate faces and duplicate links, which would count twice.
// @throws std::invalid_argument
void checkDuplicates(const RestShape& shape);

// Refuses links of length 0, faces of area 0, and material coordinates that are not finite or in which a
// triangle has less than a third or more than three times its area.
// @throws std::invalid_argument
void checkShape(const RestShape& shape, const ClothMesh& mesh);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
