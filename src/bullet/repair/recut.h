// Cloth that an application has cut, refined or sewn while it hangs, told from the cloth that it was.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/sheet/rest_shape.h"
#include "drench/cloth_mesh.h"
#include "drench/config.h"
#include "drench/moisture.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// What a body has become, and the water on it.
struct Recut {
    RestShape shape;
    ClothMesh mesh;
    std::vector<double> poreMass;  // kg
    std::vector<double> filmMass;  // kg
};

// Fits shape, mesh and water to a body whose old nodes are where they were in its array, and whose new ones, if any,
// come after them.
//
// A face of other nodes than before is a piece of the old face, near one of its old corners, that its middle is nearest
// to now, or, beside it, sewn on to it and dry; its new corners get their material coordinates from where they are in
// the plane of that face. Links between the same nodes
// keep their rest length, others along an edge get that of the material, and others again that of now. The water of
// each old face goes to its pieces, as it lay on the face; that of faces without a piece is missing from the sums.
//
// @param shape, mesh  as they were; links in the body's order
// @throws std::invalid_argument for a body that is no cloth, or no longer this one
Recut recutOf(const btSoftBody& body, const RestShape& shape, const ClothMesh& mesh,
              const Moisture& moisture);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
