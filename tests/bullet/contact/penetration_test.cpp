// Sheets of nodes that a SmallStepSolver moves, thrown at solids of every kind at 5 m/s in steps of 1/60 s.
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "bullet/world/worlds.h"

namespace drench::penetration_test {
namespace {

constexpr double speed = 5, max = 1e-3;

// How deep a point is in a solid, in the solid's own coordinates, m.
using Depth = std::function<double(const btVector3&)>;

// Deepest that any node of a square metre gets, and most of them that touch, as it is thrown down on a solid.
struct Thrown {
    double deepest = 0;
    int touching = 0;
};

Thrown throwAt(btCollisionShape& shape, const btQuaternion& turn, double height, const Depth& depth,
               double water) {
    test::SmallStepWorld rig;
    btRigidBody solid(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &shape));
    solid.setWorldTransform(btTransform(turn, {btScalar(0.013), 0, btScalar(-0.007)}));
    rig.world().addRigidBody(&solid);
    const Fabric fabric = fabrics::cottonPlain();
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 1, 41, height));
    rig.cover(sheet, fabric).soakPores(water);
    test::setVelocity(sheet, {0, btScalar(-speed), 0});
    Thrown result;
    for (int frame = 0; frame < 60; ++frame) {
        rig.run(1.0 / 60);
        result.touching = std::max(result.touching, sheet.m_rcontacts.size());
        for (int n = 0; n < sheet.m_nodes.size(); ++n)
            result.deepest =
                std::max(result.deepest, depth(solid.getWorldTransform().invXform(sheet.m_nodes[n].m_x)));
    }
    rig.world().removeRigidBody(&solid);
    return result;
}

void expectOutside(const char* name, btCollisionShape& shape, const Depth& depth) {
    const btQuaternion askew(btVector3(btScalar(0.6), btScalar(0.3), btScalar(0.74)).normalized(),
                             btScalar(0.9));
    for (const btQuaternion& turn : {btQuaternion::getIdentity(), askew})
        for (const double water : {0.0, 0.13}) {
            const Thrown thrown = throwAt(shape, turn, 0.45, depth, water);
            EXPECT_LT(thrown.deepest, max) << name << ", " << water << " kg/m2";
            EXPECT_GT(thrown.touching, 20) << name << ", " << water << " kg/m2";
        }
}

double depthInBox(const btVector3& point, const btVector3& half) {
    const btVector3 inside = half - point.absolute();
    return double(inside[inside.minAxis()]);
}

TEST(Penetration, NoNodeEndsInABallABoxOrACapsule) {
    btSphereShape ball(btScalar(0.25));
    expectOutside("ball", ball, [](const btVector3& p) { return 0.25 - double(p.length()); });
    const btVector3 half(btScalar(0.2), btScalar(0.15), btScalar(0.1));
    btBoxShape box(half);
    expectOutside("box", box, [&](const btVector3& p) { return depthInBox(p, half); });
    btCapsuleShape capsule(btScalar(0.06), btScalar(0.5));
    expectOutside("capsule", capsule, [](btVector3 p) {
        p.setY(p.y() - std::clamp(p.y(), btScalar(-0.25), btScalar(0.25)));
        return 0.06 - double(p.length());
    });
}

TEST(Penetration, NoNodeEndsInAConvexHullOrACylinder) {
    // A wedge, by the half-spaces that it is made of.
    btConvexHullShape wedge;
    const btVector3 corners[] = {{btScalar(-0.2), btScalar(-0.2), btScalar(-0.3)},
                                 {btScalar(0.2), btScalar(-0.2), btScalar(-0.3)},
                                 {0, btScalar(0.2), btScalar(-0.3)},
                                 {btScalar(-0.2), btScalar(-0.2), btScalar(0.3)},
                                 {btScalar(0.2), btScalar(-0.2), btScalar(0.3)},
                                 {0, btScalar(0.2), btScalar(0.3)}};
    for (const btVector3& corner : corners) wedge.addPoint(corner);
    wedge.setMargin(btScalar(0.004));
    expectOutside("wedge", wedge, [](const btVector3& p) {
        const double x = std::abs(double(p.x())), y = double(p.y()), z = std::abs(double(p.z()));
        const double side = (0.2 * (0.2 - y) / 0.4 - x) * 0.4 / std::hypot(0.2, 0.4);
        return std::min({side, y + 0.2, 0.3 - z});
    });
    btCylinderShape cylinder({btScalar(0.15), btScalar(0.2), btScalar(0.15)});
    expectOutside("cylinder", cylinder, [](const btVector3& p) {
        return std::min(0.15 - std::hypot(double(p.x()), double(p.z())), 0.2 - std::abs(double(p.y())));
    });
}

// A box of triangles.
void addBox(btTriangleMesh& mesh, const btVector3& half) {
    for (int axis = 0; axis < 3; ++axis)
        for (const btScalar side : {btScalar(-1), btScalar(1)}) {
            const auto corner = [&](btScalar u, btScalar v) {
                btVector3 at;
                at[axis] = side * half[axis];
                at[(axis + 1) % 3] = u * half[(axis + 1) % 3];
                at[(axis + 2) % 3] = v * half[(axis + 2) % 3];
                return at;
            };
            mesh.addTriangle(corner(-1, -1), corner(1, -1), corner(1, 1));
            mesh.addTriangle(corner(-1, -1), corner(1, 1), corner(-1, 1));
        }
}

TEST(Penetration, NoNodeEndsInATriangleMesh) {
    const btVector3 half(btScalar(0.2), btScalar(0.15), btScalar(0.1));
    btTriangleMesh triangles;
    addBox(triangles, half);
    btBvhTriangleMeshShape mesh(&triangles, true);
    expectOutside("mesh", mesh, [&](const btVector3& p) { return depthInBox(p, half); });
}

TEST(Penetration, NoNodePassesAThinWire) {
    // 4 mm thick: a node goes 83 mm in a step.
    btCapsuleShape wire(btScalar(0.002), btScalar(1.2));
    for (const double slant : {0.0, 0.6}) {
        test::SmallStepWorld rig;
        btRigidBody solid(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &wire));
        solid.setWorldTransform(btTransform(btQuaternion({1, 0, 0}, btScalar(1.5707963 + slant)), {0, 0, 0}));
        rig.world().addRigidBody(&solid);
        const Fabric fabric = fabrics::cottonPlain();
        btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 0.4, 41, 0.5));
        rig.cover(sheet, fabric);
        test::setVelocity(sheet, {0, btScalar(-speed), 0});
        rig.run(0.3);
        // It hangs over the wire: both halves below, the middle above.
        const btVector3& middle = sheet.m_nodes[20 * 41 + 20].m_x;
        EXPECT_GT(double(middle.y()), -0.3) << slant;
        rig.world().removeRigidBody(&solid);
    }
}

}  // namespace
}  // namespace drench::penetration_test
