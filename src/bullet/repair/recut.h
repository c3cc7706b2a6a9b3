// Adapts a sheet to a body that an application has cut, refined or extended.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/sheet/rest_shape.h"
#include "drench/cloth_mesh.h"
#include "drench/config.h"
#include "drench/moisture.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// The cloth of a changed body, and its water.
struct Recut {
    RestShape shape;
    ClothMesh mesh;
    std::vector<double> poreMass;  // kg
    std::vector<double> filmMass;  // kg
};

// Computes shape, mesh and water of a changed body. Old nodes must have kept their index; new nodes, if any,
// come after them.
//
// A face with other nodes than before is assigned to an old face near one of its old corners: the one nearest
// to its middle in the present positions. It is either a piece of that face or was added beside it; then it
// is dry. The material coordinates of its new corners follow from their position in the plane of that face.
// Links between the same nodes keep their rest length; other links along an edge get the length in the
// material; all others get their present length. The water of each old face is distributed over its pieces as
// it lay on the face; that of faces without a piece is missing from the sums.
//
// @param shape, mesh  before the change; links in the body's order
// @throws std::invalid_argument for a body that is not a valid cloth, or whose change cannot be followed
Recut recutOf(const btSoftBody& body, const RestShape& shape, const ClothMesh& mesh,
              const Moisture& moisture);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
