// Distance of a point from a solid.
#pragma once

#include <BulletSoftBody/btSparseSDF.h>

#include <array>

#include "bullet/contact/solid_parts.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

struct SurfacePoint {
    btScalar distance;  // m; negative inside
    btVector3 normal;   // outward unit vector
};

// The nearest surface point of a convex shape: exact for spheres, boxes and capsules, and by GJK and EPA for
// other shapes; from Bullet's distance field, at the resolution of its voxels, where these do not converge.
// Convex hulls include their margin.
// @param point  in the coordinates of the shape, m
SurfacePoint nearestSurface(const btConvexShape& shape, const btVector3& point, btSparseSdf<3>& field);

// The nearest point of a triangle; the normal points to the side of the point.
SurfacePoint nearestOnTriangle(const std::array<btVector3, 3>& corners, const btVector3& point);

// The same of a part of a solid, in the coordinates of the solid.
SurfacePoint nearestOn(const SolidPart& part, const btVector3& point, btSparseSdf<3>& field);

// The unit normal of a triangle on the side of the point.
btVector3 normalOfTriangle(const std::array<btVector3, 3>& corners, const btVector3& point);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
