// Decides which parts of a composed surface count for a contact of a node.
#pragma once

#include <LinearMath/btVector3.h>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// The plane of a contact is infinite. If level ground consists of several parts (faces, triangles, boxes side
// by side, or children of a compound shape), the part below a node is the nearest. The nearest point of the
// neighbouring part is on its edge, and the plane through that point that faces the node does not belong to
// the surface; it would stop a node that slides along. So only the nearest part counts, and those parts that
// rise above its plane.

// Whether a part rises above the plane of the nearest part.
// @param height  of its highest point above that plane, m
// @param margin  of the contact, m; a tenth of it counts as level
inline bool risesAbove(btScalar height, btScalar margin) {
    constexpr auto level = btScalar(0.1);
    return !(height < level * margin);
}

// Whether two parts face a node from about the same side, within 45 degrees, and so count as one contact.
inline bool faceAlike(const btVector3& normal, const btVector3& other) {
    constexpr auto alike = btScalar(0.7);
    return normal.dot(other) > alike;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
