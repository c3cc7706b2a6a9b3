// How far a point is from a solid.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletSoftBody/btSparseSDF.h>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

struct SurfacePoint {
    btScalar distance;  // m; negative inside
    btVector3 normal;   // outwards, of unit length
};

// The nearest surface of a solid's shape: exact for spheres, boxes, capsules and, by GJK and EPA, all that is
// convex; by Bullet's distance field, as fine as its voxels, for the rest. Convex hulls have their margin around them.
SurfacePoint nearestSurface(const btCollisionShape& shape, const btTransform& transform,
                            const btVector3& point, btSparseSdf<3>& field);

// Whether a shape is a triangle of a mesh, which Bullet hands out as a hull of six points, three on either side
// and far off, so that soft bodies float above meshes.
bool isTriangleOfMesh(const btCollisionObjectWrapper& solid);

// The nearest point of such a triangle, of no thickness; outwards is where the point is.
SurfacePoint nearestOnTriangle(const btCollisionShape& hull, const btTransform& transform,
                               const btVector3& point);

// The normal of such a triangle on the side where the point is.
btVector3 normalOfTriangle(const btCollisionShape& hull, const btTransform& transform,
                           const btVector3& point);

// How far a solid's shape reaches along a direction, as a place along it, m; infinitely far if it is not convex.
btScalar farthestAlong(const btCollisionShape& shape, const btTransform& transform,
                       const btVector3& direction);
// The same of a triangle.
btScalar farthestOfTriangle(const btCollisionShape& hull, const btTransform& transform,
                            const btVector3& direction);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
