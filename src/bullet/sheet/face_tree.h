// Bullet's trees of the faces of a soft body.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Builds the same trees as btSoftBody::initializeFaceTree, which takes quadratic time, and never returns for
// cloth in two pieces. Like that function it also rebuilds the tree of nodes. Existing trees are replaced.
void makeFaceTree(btSoftBody& body);

// Removes the trees of faces.
void dropFaceTree(btSoftBody& body);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
