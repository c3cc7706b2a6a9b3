#include "bullet/contact/solid_distance.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

const btVector3 anyDirection(0, 1, 0);

// Distance and normal of a surface at `radius` around a centre or an axis.
SurfacePoint around(const btVector3& offset, btScalar radius) {
    const btScalar length = offset.length();
    return {length - radius, length > SIMD_EPSILON ? offset / length : anyDirection};
}

SurfacePoint ofCapsule(const btCapsuleShape& capsule, const btVector3& point) {
    const int axis = capsule.getUpAxis();
    const btScalar half = capsule.getHalfHeight();
    btVector3 offset = point;
    offset[axis] -= std::clamp(point[axis], -half, half);
    return around(offset, capsule.getRadius());
}

SurfacePoint ofBox(const btBoxShape& box, const btVector3& point) {
    const btVector3 half = box.getHalfExtentsWithMargin();
    btVector3 outside(0, 0, 0);
    int nearest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        outside[axis] = point[axis] - std::clamp(point[axis], -half[axis], half[axis]);
        if (std::abs(point[axis]) - half[axis] > std::abs(point[nearest]) - half[nearest]) nearest = axis;
    }
    if (!outside.isZero()) return around(outside, 0);
    btVector3 normal(0, 0, 0);
    normal[nearest] = point[nearest] < 0 ? btScalar(-1) : btScalar(1);
    return {std::abs(point[nearest]) - half[nearest], normal};
}

SurfacePoint ofConvex(const btConvexShape& shape, const btVector3& point, btSparseSdf<3>& field) {
    btGjkEpaSolver2::sResults results;
    results.normal.setZero();
    SurfacePoint found;
    found.distance = btGjkEpaSolver2::SignedDistance(point, 0, &shape, btTransform::getIdentity(), results);
    found.normal = results.normal;
    // Inside the shape Bullet's distance omits the margin.
    if (results.status == btGjkEpaSolver2::sResults::Penetrating)
        found.distance -= shape.getMarginNonVirtual();
    // Exactly on the surface neither of the two algorithms finds a direction.
    constexpr auto rounding = btScalar(0.01);
    const bool isFound = found.distance < BT_LARGE_FLOAT && std::abs(found.normal.length2() - 1) < rounding;
    if (!isFound) found.distance = field.Evaluate(point, &shape, found.normal, 0);
    return found;
}

using Triangle = std::array<btVector3, 3>;

// Bullet represents a triangle by six points, three on each side.
Triangle triangleOf(const btCollisionShape& hull) {
    const auto& points = static_cast<const btConvexHullShape&>(hull);
    Triangle corners;
    for (int i = 0; i < 3; ++i)
        corners[static_cast<std::size_t>(i)] = (points.getScaledPoint(i) + points.getScaledPoint(i + 3)) / 2;
    return corners;
}

btVector3 normalOf(const Triangle& triangle) {
    return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
}

}  // namespace

SurfacePoint nearestSurface(const btCollisionShape& shape, const btTransform& transform,
                            const btVector3& point, btSparseSdf<3>& field) {
    const btVector3 local = transform.invXform(point);
    SurfacePoint found;
    switch (shape.getShapeType()) {
        case SPHERE_SHAPE_PROXYTYPE:
            found = around(local, static_cast<const btSphereShape&>(shape).getRadius());
            break;
        case BOX_SHAPE_PROXYTYPE:
            found = ofBox(static_cast<const btBoxShape&>(shape), local);
            break;
        case CAPSULE_SHAPE_PROXYTYPE:
            found = ofCapsule(static_cast<const btCapsuleShape&>(shape), local);
            break;
        default:
            if (shape.isConvex())
                found = ofConvex(static_cast<const btConvexShape&>(shape), local, field);
            else
                found.distance = field.Evaluate(local, &shape, found.normal, 0);
    }
    found.normal = transform.getBasis() * found.normal;
    return found;
}

bool isTriangleOfMesh(const btCollisionObjectWrapper& solid) {
    constexpr int corners = 6;
    const btCollisionShape& shape = *solid.getCollisionShape();
    // Triangles have an index but no parent; children of a compound have both.
    return solid.m_index >= 0 && !solid.m_parent &&
           !solid.getCollisionObject()->getCollisionShape()->isConvex() &&
           shape.getShapeType() == CONVEX_HULL_SHAPE_PROXYTYPE &&
           static_cast<const btConvexHullShape&>(shape).getNumPoints() == corners;
}

SurfacePoint nearestOnTriangle(const btCollisionShape& hull, const btTransform& transform,
                               const btVector3& point) {
    const Triangle triangle = triangleOf(hull);
    const btVector3 local = transform.invXform(point);
    btVoronoiSimplexSolver simplex;
    btSubSimplexClosestResult nearest;
    simplex.closestPtPointTriangle(local, triangle[0], triangle[1], triangle[2], nearest);
    SurfacePoint found = around(local - nearest.m_closestPointOnSimplex, 0);
    if (!(found.distance > SIMD_EPSILON)) found.normal = normalOf(triangle);
    found.normal = transform.getBasis() * found.normal;
    return found;
}

btVector3 normalOfTriangle(const btCollisionShape& hull, const btTransform& transform,
                           const btVector3& point) {
    const Triangle triangle = triangleOf(hull);
    const btVector3 normal = normalOf(triangle);
    const bool isBehind = normal.dot(transform.invXform(point) - triangle[0]) < 0;
    return transform.getBasis() * (isBehind ? -normal : normal);
}

btScalar farthestAlong(const btCollisionShape& shape, const btTransform& transform,
                       const btVector3& direction) {
    if (!shape.isConvex()) return BT_LARGE_FLOAT;
    const auto& convex = static_cast<const btConvexShape&>(shape);
    const btVector3 local = direction * transform.getBasis();
    return direction.dot(transform * convex.localGetSupportingVertex(local));
}

btScalar farthestOfTriangle(const btCollisionShape& hull, const btTransform& transform,
                            const btVector3& direction) {
    btScalar farthest = -BT_LARGE_FLOAT;
    for (const btVector3& corner : triangleOf(hull))
        farthest = std::max(farthest, direction.dot(transform * corner));
    return farthest;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
