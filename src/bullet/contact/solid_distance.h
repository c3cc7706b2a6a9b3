// Distance of a point from a solid.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletSoftBody/btSparseSDF.h>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

struct SurfacePoint {
    btScalar distance;  // m; negative inside
    btVector3 normal;   // outward unit vector
};

// The nearest surface point of a solid's shape: exact for spheres, boxes and capsules, and by GJK and EPA for
// other convex shapes; from Bullet's distance field, at the resolution of its voxels, for all others. Convex
// hulls include their margin.
SurfacePoint nearestSurface(const btCollisionShape& shape, const btTransform& transform,
                            const btVector3& point, btSparseSdf<3>& field);

// Whether a shape is a triangle of a mesh. Bullet represents it as a hull of six points, three at a distance
// on each side, so soft bodies float above meshes.
bool isTriangleOfMesh(const btCollisionObjectWrapper& solid);

// The nearest point of such a triangle, without its thickness; the normal points to the side of the point.
SurfacePoint nearestOnTriangle(const btCollisionShape& hull, const btTransform& transform,
                               const btVector3& point);

// The normal of such a triangle on the side of the point.
btVector3 normalOfTriangle(const btCollisionShape& hull, const btTransform& transform,
                           const btVector3& point);

// The extent of a solid's shape along a direction, as a coordinate along it, m; infinite if it is not convex.
btScalar farthestAlong(const btCollisionShape& shape, const btTransform& transform,
                       const btVector3& direction);
// The same for a triangle.
btScalar farthestOfTriangle(const btCollisionShape& hull, const btTransform& transform,
                            const btVector3& direction);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
