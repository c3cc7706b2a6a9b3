#include "bullet/contact/solid_distance.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>

#include <algorithm>
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

// Nearest point of a triangle, by the region of its plane in which the point lies (Ericson 2005, "Real-time
// collision detection", 5.1.5).
btVector3 closestOnTriangle(const std::array<btVector3, 3>& corners, const btVector3& point) {
    const btVector3 &a = corners[0], &b = corners[1], &c = corners[2];
    const btVector3 ab = b - a, ac = c - a, fromA = point - a, fromB = point - b, fromC = point - c;
    const btScalar abA = ab.dot(fromA), acA = ac.dot(fromA);
    if (abA <= 0 && acA <= 0) return a;
    const btScalar abB = ab.dot(fromB), acB = ac.dot(fromB);
    if (abB >= 0 && acB <= abB) return b;
    const btScalar weightC = abA * acB - abB * acA;
    if (weightC <= 0 && abA >= 0 && abB <= 0) return a + ab * (abA > abB ? abA / (abA - abB) : 0);
    const btScalar abC = ab.dot(fromC), acC = ac.dot(fromC);
    if (acC >= 0 && abC <= acC) return c;
    const btScalar weightB = abC * acA - abA * acC;
    if (weightB <= 0 && acA >= 0 && acC <= 0) return a + ac * (acA > acC ? acA / (acA - acC) : 0);
    const btScalar weightA = abB * acC - abC * acB;
    const btScalar alongB = acB - abB, alongC = abC - acC;
    if (weightA <= 0 && alongB >= 0 && alongC >= 0)
        return b + (c - b) * (alongB + alongC > 0 ? alongB / (alongB + alongC) : 0);
    const btScalar all = weightA + weightB + weightC;
    return a + ab * (weightB / all) + ac * (weightC / all);
}

}  // namespace

SurfacePoint nearestSurface(const btConvexShape& shape, const btVector3& point, btSparseSdf<3>& field) {
    switch (shape.getShapeType()) {
        case SPHERE_SHAPE_PROXYTYPE:
            return around(point, static_cast<const btSphereShape&>(shape).getRadius());
        case BOX_SHAPE_PROXYTYPE:
            return ofBox(static_cast<const btBoxShape&>(shape), point);
        case CAPSULE_SHAPE_PROXYTYPE:
            return ofCapsule(static_cast<const btCapsuleShape&>(shape), point);
        default:
            return ofConvex(shape, point, field);
    }
}

SurfacePoint nearestOnTriangle(const std::array<btVector3, 3>& corners, const btVector3& point) {
    SurfacePoint found = around(point - closestOnTriangle(corners, point), 0);
    if (!(found.distance > SIMD_EPSILON)) found.normal = normalOfTriangle(corners, point);
    return found;
}

SurfacePoint nearestOn(const SolidPart& part, const btVector3& point, btSparseSdf<3>& field) {
    if (!part.convex) return nearestOnTriangle(part.corners, point);
    SurfacePoint found = nearestSurface(*part.convex, part.inSolid.invXform(point), field);
    found.normal = part.inSolid.getBasis() * found.normal;
    return found;
}

btVector3 normalOfTriangle(const std::array<btVector3, 3>& corners, const btVector3& point) {
    const btVector3 area = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const btScalar length = area.length();
    if (!(length > 0)) return anyDirection;
    return area * ((area.dot(point - corners[0]) < 0 ? -1 : 1) / length);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
