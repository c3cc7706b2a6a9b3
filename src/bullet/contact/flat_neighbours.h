// Which of the parts of a surface that a node meets stand in its way.
#pragma once

#include <LinearMath/btVector3.h>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// The plane of a contact has no end. Of level ground in several parts, be they faces, triangles, boxes side by side or
// children of a compound, the part under a node is nearest, and the next one is nearest at its edge: a plane that faces
// the node from there is none of its surface, and would stop a node that slides along. So of what a node might touch
// the nearest part counts, and of the others those that rise above its plane.

// Whether a part rises above the plane of the nearest one.
// @param height  of its highest point over that plane, m
// @param margin  of the contact, m; a tenth of it counts as level
inline bool risesAbove(btScalar height, btScalar margin) {
    constexpr auto level = btScalar(0.1);
    return !(height < level * margin);
}

// Whether two parts face a node from about the same side, within 45 degrees, and so press on it once.
inline bool faceAlike(const btVector3& normal, const btVector3& other) {
    constexpr auto alike = btScalar(0.7);
    return normal.dot(other) > alike;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
