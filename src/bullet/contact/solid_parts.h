// The parts of which the shape of a solid consists.
#pragma once

#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <LinearMath/btTransform.h>

#include <array>
#include <vector>

#include "bullet/world/bounds.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// A convex shape, or a triangle of a mesh or height field.
struct SolidPart {
    const btConvexShape* convex;       // null for a triangle
    btTransform inSolid;               // frame of the convex shape, in the coordinates of the solid
    std::array<btVector3, 3> corners;  // of the triangle, in the coordinates of the solid, m
    Bounds bounds;                     // around the part, in the coordinates of the solid

    // The largest coordinate of the part along a direction, both in the coordinates of the solid, m.
    btScalar farthestAlong(const btVector3& direction) const;
};

// Appends the parts of a shape that meet a box. Triangles are asked of the shape itself, in its present form:
// what Bullet passes to soft bodies is a copy that Bullet keeps while the mesh changes, at a place that
// ignores where the mesh is within a compound shape. Shapes that are neither convex nor made of convex shapes
// or triangles (btSdfCollisionShape) have no parts.
// @param inSolid  frame of the shape, in the coordinates of the solid
// @param box      in the coordinates of the solid
void addParts(std::vector<SolidPart>& parts, const btCollisionShape& shape, const btTransform& inSolid,
              const Bounds& box);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
