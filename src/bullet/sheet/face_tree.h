// The trees in which Bullet looks for the faces of a soft body.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Builds the trees of faces that btSoftBody::initializeFaceTree builds, which compares all faces with all others, and
// never ends for cloth of two pieces; and as that does, the tree of nodes anew. In place of those that there are.
void makeFaceTree(btSoftBody& body);

// Drops them.
void dropFaceTree(btSoftBody& body);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
