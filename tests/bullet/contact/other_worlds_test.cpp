// What applications do with solids: they remove them in callbacks, drive, scale and edit them, put meshes into compounds,
// and move everything to another place.
#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletCollision/CollisionShapes/btScaledBvhTriangleMeshShape.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftMultiBodyDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>
#include <drench/drench.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "bullet/world/worlds.h"

namespace drench::other_worlds_test {
namespace {

constexpr btScalar frame = btScalar(1) / 60;

btTransform at(double x, double y, double z) {
    return btTransform(btQuaternion::getIdentity(), {btScalar(x), btScalar(y), btScalar(z)});
}

// A world with solids and one sheet, which leave it before it goes.
class Place {
  public:
    Place() {
        world.setGravity({0, btScalar(-9.81), 0});
        world.getWorldInfo().m_gravity = world.getGravity();
    }
    ~Place() {
        cloth.reset();
        if (sheet) world.removeSoftBody(sheet.get());
        for (const auto& body : bodies_) world.removeRigidBody(body.get());
    }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

    btRigidBody& add(btCollisionShape& shape, const btTransform& pose, bool isKinematic = false,
                     double friction = 1) {
        states_.push_back(std::make_unique<btDefaultMotionState>(pose));
        bodies_.push_back(std::make_unique<btRigidBody>(
            btRigidBody::btRigidBodyConstructionInfo(0, states_.back().get(), &shape)));
        btRigidBody& body = *bodies_.back();
        body.setFriction(btScalar(friction));
        if (isKinematic) {
            body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
            body.setActivationState(DISABLE_DEACTIVATION);
        }
        world.addRigidBody(&body);
        return body;
    }
    // Gives the body to the test, which destroys it.
    std::unique_ptr<btRigidBody> take(btRigidBody& body) {
        for (auto& each : bodies_) {
            if (each.get() != &body) continue;
            std::unique_ptr<btRigidBody> taken = std::move(each);
            bodies_.erase(bodies_.begin() + (&each - bodies_.data()));
            world.removeRigidBody(taken.get());
            return taken;
        }
        return nullptr;
    }

    // A level sheet of that side, m, around a centre; warp along x.
    void lay(double side, const btVector3& centre, int nodes, const SheetSettings& settings = {}) {
        const btScalar half = btScalar(side) / 2;
        sheet = makeSheet(world.getWorldInfo(), fabrics::cottonPlain(),
                          flatCorners(centre - btVector3(half, 0, half), {2 * half, 0, 0}, {0, 0, 2 * half}),
                          nodes, nodes);
        world.addSoftBody(sheet.get());
        cloth = std::make_unique<WetCloth>(world, *sheet, fabrics::cottonPlain(), settings);
    }
    // A sheet that hangs in the plane z = 0; its upper edge is at that height, m.
    void hang(double side, double height, int nodes) {
        const auto length = btScalar(side);
        sheet = makeSheet(world.getWorldInfo(), fabrics::cottonPlain(),
                          flatCorners({-length / 2, btScalar(height), 0}, {length, 0, 0}, {0, -length, 0}),
                          nodes, nodes);
        world.addSoftBody(sheet.get());
        cloth = std::make_unique<WetCloth>(world, *sheet, fabrics::cottonPlain());
    }

    void step(int frames, const std::function<void()>& before = {}) {
        for (int f = 0; f < frames; ++f) {
            if (before) before();
            world.stepSimulation(frame, 1, frame);
        }
    }
    double lowest() const {
        double low = 1e9;
        for (int n = 0; n < sheet->m_nodes.size(); ++n)
            low = std::min(low, double(sheet->m_nodes[n].m_x.y()));
        return low;
    }
    double fastest() const {
        double fast = 0;
        for (int n = 0; n < sheet->m_nodes.size(); ++n)
            fast = std::max(fast, double(sheet->m_nodes[n].m_v.length()));
        return fast;
    }

    SmallStepSolver small;
    btSoftBodyRigidBodyCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btMultiBodyConstraintSolver solver;
    btSoftMultiBodyDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration, &small};
    std::unique_ptr<btSoftBody> sheet;
    std::unique_ptr<WetCloth> cloth;

  private:
    std::vector<std::unique_ptr<btDefaultMotionState>> states_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

// --- Solids that go while the world steps

std::function<void()> onTick;  // of the callback, which gets no user data

void runTick(btDynamicsWorld*, btScalar) {
    if (onTick) onTick();
    onTick = nullptr;
}

class Callback : public testing::Test, public btActionInterface {
  public:
    ~Callback() override { onTick = nullptr; }
    void updateAction(btCollisionWorld*, btScalar) override { runTick(nullptr, 0); }
    void debugDraw(btIDebugDraw*) override {}

  protected:
    Place place;
};

TEST_F(Callback, MayRemoveASolidAfterTheCollisionsWereFound) {
    for (const bool asAction : {false, true}) {
        SCOPED_TRACE(asAction ? "action" : "post-tick");
        Place here;
        auto shape = std::make_unique<btBoxShape>(btVector3(btScalar(0.2), btScalar(0.1), btScalar(0.2)));
        btRigidBody& box = here.add(*shape, at(0, -0.1, 0));
        here.lay(0.3, {0, btScalar(0.02), 0}, 9);
        here.step(30);
        ASSERT_GT(here.lowest(), 0);
        onTick = [&] {
            here.take(box).reset();
            shape.reset();
        };
        if (asAction)
            here.world.addAction(this);
        else
            here.world.setInternalTickCallback(runTick, nullptr, false);
        here.step(30);
        EXPECT_TRUE(here.cloth->health().finite);
        EXPECT_LT(here.lowest(), -0.3) << "it falls, for nothing is there";
        if (asAction) here.world.removeAction(this);
    }
}

TEST_F(Callback, MayExchangeTheShapeOfASolid) {
    auto shape = std::make_unique<btBoxShape>(btVector3(btScalar(0.2), btScalar(0.1), btScalar(0.2)));
    btBoxShape other({btScalar(0.2), btScalar(0.05), btScalar(0.2)});
    btRigidBody& box = place.add(*shape, at(0, -0.1, 0));
    place.lay(0.3, {0, btScalar(0.02), 0}, 9);
    place.step(30);
    onTick = [&] {
        box.setCollisionShape(&other);
        shape.reset();
    };
    place.world.setInternalTickCallback(runTick, nullptr, false);
    place.step(60);
    EXPECT_NEAR(place.lowest(), -0.05 + double(place.sheet->getCollisionShape()->getMargin()), 1e-3);
}

TEST_F(Callback, MayRemoveAChildOfACompound) {
    auto child = std::make_unique<btBoxShape>(btVector3(btScalar(0.2), btScalar(0.1), btScalar(0.2)));
    btBoxShape floor({1, btScalar(0.1), 1});
    btCompoundShape compound;
    compound.addChildShape(at(0, 0, 0), child.get());
    compound.addChildShape(at(0, -0.4, 0), &floor);
    place.add(compound, at(0, -0.1, 0));
    place.lay(0.3, {0, btScalar(0.02), 0}, 9);
    place.step(30);
    onTick = [&] {
        compound.removeChildShape(child.get());
        child.reset();
    };
    place.world.setInternalTickCallback(runTick, nullptr, false);
    place.step(120);
    EXPECT_NEAR(place.lowest(), -0.4 + double(place.sheet->getCollisionShape()->getMargin()), 1e-3);
}

// --- Triangles where and as they are

void addGround(btTriangleMesh& mesh, double height, int cells, double side) {
    const btScalar cell = btScalar(side) / btScalar(cells), half = btScalar(side) / 2;
    const auto corner = [&](int i, int j) {
        return btVector3(btScalar(i) * cell - half, btScalar(height), btScalar(j) * cell - half);
    };
    for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j) {
            mesh.addTriangle(corner(i, j), corner(i, j + 1), corner(i + 1, j));
            mesh.addTriangle(corner(i + 1, j), corner(i, j + 1), corner(i + 1, j + 1));
        }
}

// Moves all vertices of a mesh to a height, m.
void setHeight(btTriangleMesh& mesh, btScalar height) {
    unsigned char *vertices = nullptr, *indices = nullptr;
    int count = 0, stride = 0, indexStride = 0, faces = 0;
    PHY_ScalarType type, indexType;
    mesh.getLockedVertexIndexBase(&vertices, count, type, stride, &indices, indexStride, faces, indexType, 0);
    for (int i = 0; i < count; ++i) reinterpret_cast<btScalar*>(vertices + i * stride)[1] = height;
    mesh.unLockVertexBase(0);
}

TEST(OtherWorlds, AMeshInACompoundIsWhereTheCompoundPutsIt) {
    // Half a metre up and turned upside down, in a compound within a compound that brings it back.
    btTriangleMesh triangles;
    addGround(triangles, 0.5, 4, 2);
    btBvhTriangleMeshShape mesh(&triangles, true);
    for (const bool upsideDown : {false, true}) {
        btCompoundShape inner, outer;
        const btTransform turn(btQuaternion(btVector3(0, 0, 1), upsideDown ? SIMD_PI : 0));
        inner.addChildShape(turn, &mesh);
        outer.addChildShape(at(0, upsideDown ? 0.5 : -0.5, 0), &inner);
        Place place;
        place.add(outer, at(0, 0, 0));
        place.lay(0.2, {0, btScalar(0.1), 0}, 5);
        place.step(120);
        EXPECT_NEAR(place.lowest(), double(place.sheet->getCollisionShape()->getMargin()), 1e-3)
            << upsideDown;
    }
}

TEST(OtherWorlds, AMeshThatIsRefittedOrScaledCarriesTheClothAlong) {
    btTriangleMesh triangles;
    addGround(triangles, 0.1, 4, 1);
    btBvhTriangleMeshShape mesh(&triangles, true);
    btScaledBvhTriangleMeshShape scaled(&mesh, {1, 1, 1});
    for (const bool isScaled : {false, true}) {
        Place place;
        place.add(isScaled ? static_cast<btCollisionShape&>(scaled) : mesh, at(0, 0, 0));
        place.lay(0.2, {0, btScalar(0.13), 0}, 5);
        place.step(30);
        btScalar height = btScalar(0.1);
        place.step(60, [&] {
            height += btScalar(0.001);
            if (isScaled) {
                scaled.setLocalScaling({1, height / btScalar(0.1), 1});
                return;
            }
            setHeight(triangles, height);
            mesh.refitTree({-1, -1, -1}, {1, 1, 1});
        });
        EXPECT_NEAR(place.lowest(), double(height) + double(place.sheet->getCollisionShape()->getMargin()),
                    2e-3)
            << isScaled;
        if (!isScaled) {
            setHeight(triangles, btScalar(0.1));
            mesh.refitTree({-1, -1, -1}, {1, 1, 1});
        }
    }
}

TEST(OtherWorlds, AHeightFieldMayBeEditedAndMayBeLarge) {
    constexpr int columns = 1300, rows = 64;  // Bullet's keys of triangles repeat beyond 1,024
    std::vector<btScalar> heights(static_cast<std::size_t>(columns * rows), 0);
    btHeightfieldTerrainShape field(columns, rows, heights.data(), btScalar(-1), btScalar(1), 1, false);
    const btScalar cell = btScalar(0.02);
    field.setLocalScaling({cell, 1, cell});
    for (const double column : {300.0, 1250.0}) {
        std::fill(heights.begin(), heights.end(), btScalar(0));
        Place place;
        place.add(field, at(0, 0, 0));
        const auto x = btScalar(column - (columns - 1) / 2.0) * cell;
        place.lay(0.2, {x, btScalar(0.03), 0}, 9);
        place.step(30);
        btScalar height = 0;
        place.step(60, [&] {
            height += btScalar(0.002);
            std::fill(heights.begin(), heights.end(), height);
        });
        EXPECT_NEAR(place.lowest(), double(height) + double(place.sheet->getCollisionShape()->getMargin()),
                    3e-3)
            << column;
    }
}

TEST(OtherWorlds, ClothRestsOnBumps) {
    btTriangleMesh triangles;
    const auto bump = [](int i, int j) {
        const double x = (i - 3) * 0.1, z = (j - 3) * 0.1;
        const double height = 0.1 * std::sin(4 * M_PI * x) * std::cos(4 * M_PI * z);
        return btVector3(btScalar(x), btScalar(height), btScalar(z));
    };
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
            triangles.addTriangle(bump(i, j), bump(i, j + 1), bump(i + 1, j));
            triangles.addTriangle(bump(i + 1, j), bump(i, j + 1), bump(i + 1, j + 1));
        }
    btBvhTriangleMeshShape mesh(&triangles, true);
    for (const int nodes : {9, 15}) {
        Place place;
        place.add(mesh, at(0, 0, 0));
        place.lay(0.5, {0, btScalar(0.13), 0}, nodes);
        place.step(300);
        EXPECT_LT(place.fastest(), 1e-3) << nodes;
        EXPECT_GT(place.lowest(), -0.1);
    }
}

// --- Solids that drive and spin

TEST(OtherWorlds, ClothStaysOnAFloorThatDrives) {
    btTriangleMesh triangles;
    addGround(triangles, 0, 8, 2);
    btBvhTriangleMeshShape mesh(&triangles, true);
    btBoxShape box({1, btScalar(0.1), 1});
    for (const btVector3& velocity :
         {btVector3(2, 0, 0), btVector3(0, -10, 0), btVector3(0, 10, 0), btVector3(20, 0, 0)})
        for (const bool isMesh : {false, true})
            for (const int substeps : {1, 4}) {
                Place place;
                const btTransform start = isMesh ? at(0, 0, 0) : at(0, -0.1, 0);
                btRigidBody& floor =
                    place.add(isMesh ? static_cast<btCollisionShape&>(mesh) : box, start, true);
                place.lay(0.9, {0, btScalar(0.03), 0}, 9);
                place.cloth->air().wind = {double(velocity.x()), double(velocity.y()), double(velocity.z())};
                for (int n = 0; n < place.sheet->m_nodes.size(); ++n) place.sheet->m_nodes[n].m_v = velocity;
                btVector3 way(0, 0, 0);
                double deepest = 0, farthest = 0;
                for (int f = 0; f < 120; ++f) {
                    way += velocity * frame;
                    floor.getMotionState()->setWorldTransform(btTransform(btQuaternion::getIdentity(), way) *
                                                              start);
                    place.world.stepSimulation(frame, substeps, frame / btScalar(substeps));
                    for (int n = 0; n < place.sheet->m_nodes.size(); ++n) {
                        const btVector3 local = place.sheet->m_nodes[n].m_x - way;
                        deepest = std::max(deepest, -double(local.y()));
                        farthest = std::max(farthest, double(std::abs(local.x())));
                    }
                }
                EXPECT_LT(deepest, 1e-4)
                    << velocity.x() << ' ' << velocity.y() << ' ' << isMesh << ' ' << substeps;
                EXPECT_LT(farthest, 0.46)
                    << velocity.x() << ' ' << velocity.y() << ' ' << isMesh << ' ' << substeps;
            }
}

TEST(OtherWorlds, APaddleOfTwoMetresSweepsClothAlong) {
    btBoxShape paddle({1, btScalar(0.3), btScalar(0.02)});
    for (const int substeps : {1, 3}) {
        Place place;
        place.world.getWorldInfo().m_gravity.setZero();
        place.world.setGravity({0, 0, 0});
        btRigidBody& body = place.add(paddle, at(0, 0, 0), true);
        place.hang(0.3, 0.15, 9);
        for (int n = 0; n < place.sheet->m_nodes.size(); ++n)
            place.sheet->m_nodes[n].m_x += btVector3(btScalar(0.75), 0, btScalar(-0.15));
        place.step(1);
        double angle = 0, deepest = 0;
        for (int f = 0; f < 12; ++f) {
            angle += 15.0 / 60;
            btTransform pose = at(0, 0, 0);
            pose.setRotation(btQuaternion(btVector3(0, 1, 0), btScalar(angle)));
            body.getMotionState()->setWorldTransform(pose);
            place.world.stepSimulation(frame, substeps, frame / btScalar(substeps));
            for (int n = 0; n < place.sheet->m_nodes.size(); ++n) {
                const btVector3 local = pose.invXform(place.sheet->m_nodes[n].m_x);
                const double inside =
                    std::min({1 - std::abs(double(local.x())), 0.3 - std::abs(double(local.y())),
                              0.02 - std::abs(double(local.z()))});
                deepest = std::max(deepest, inside);
            }
        }
        EXPECT_LT(deepest, 1e-3) << substeps;
        EXPECT_GT(place.fastest(), 5) << "it was not hit";
    }
}

TEST(OtherWorlds, WhatFliesPastDoesNotPush) {
    for (const double radius : {0.02, 0.1, 0.5})
        for (const double speed : {5.0, 20.0, 60.0})
            for (const bool isBelow : {false, true}) {
                Place place;
                place.hang(1, 1, 5);
                for (int n = 0; n < 5; ++n) place.sheet->m_nodes[n].m_im = 0;
                place.step(180);
                btSphereShape shape{btScalar(radius)};
                const double clearance =
                    radius + double(place.sheet->getCollisionShape()->getMargin()) + 0.01;
                const btTransform start =
                    isBelow ? at(0, place.lowest() - clearance, -3.01) : at(0.5 + clearance, 0.5, -3.01);
                btRigidBody& ball = place.add(shape, start, true);
                btScalar way = 0;
                double fastest = 0;
                place.step(int(360 / speed) + 10, [&] {
                    fastest = std::max(fastest, place.fastest());
                    way += btScalar(speed) * frame;
                    ball.getMotionState()->setWorldTransform(at(0, 0, double(way)) * start);
                });
                EXPECT_LT(fastest, 0.01)
                    << radius << " m at " << speed << " m/s, " << (isBelow ? "below" : "beside");
            }
}

// A sheet flies past a post, in its plane or broadside with the post beside its border; the way of a node in a substep is
// long against the distance between them.
TEST(OtherWorlds, ASheetThatFliesPastAPostIsNotPushed) {
    constexpr double radius = 0.03, clearance = 0.005;
    btCylinderShape cylinder({btScalar(radius), 1, btScalar(radius)});
    btCapsuleShape capsule(btScalar(radius), 2);
    btBoxShape box({btScalar(radius), 1, btScalar(radius)});
    for (btCollisionShape* const shape : std::vector<btCollisionShape*>{&cylinder, &capsule, &box})
        for (const double speed : {5.0, 20.0, 40.0})
            for (const bool isBroadside : {false, true}) {
                test::SmallStepWorld rig;
                rig.setGravity({0, 0, 0});
                const btVector3 along =
                    isBroadside ? btVector3(0, 0, btScalar(0.5)) : btVector3(btScalar(0.5), 0, 0);
                btSoftBody& sheet = rig.add(
                    makeSheet(rig.info(), fabrics::cottonPlain(),
                              flatCorners({0, btScalar(-0.25), 0}, {0, btScalar(0.5), 0}, along), 17, 17));
                rig.cover(sheet, fabrics::cottonPlain(), test::withoutAir());
                const double beside = radius + double(sheet.getCollisionShape()->getMargin()) + clearance;
                btRigidBody post(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, shape));
                post.setWorldTransform(at(1.3, 0, -beside));
                rig.world().addRigidBody(&post);
                const btVector3 velocity(btScalar(speed), 0, 0);
                test::setVelocity(sheet, velocity);
                rig.run(3 / speed);
                double most = 0;
                for (int n = 0; n < sheet.m_nodes.size(); ++n)
                    most = std::max(most, double((sheet.m_nodes[n].m_v - velocity).length()));
                EXPECT_LT(most, 1e-3) << shape->getName() << " at " << speed << " m/s, "
                                      << (isBroadside ? "broadside" : "in its plane");
                EXPECT_GT(sheet.m_nodes[0].m_x.x(), 1.5) << "it has not passed";
                rig.world().removeRigidBody(&post);
            }
}

// --- Robots

TEST(OtherWorlds, AMultiBodyGripsAndLiftsAsAKinematicBodyDoes) {
    btBoxShape jaw({btScalar(0.03), btScalar(0.03), btScalar(0.01)});
    btCompoundShape jaws;
    for (const int side : {-1, 1}) jaws.addChildShape(at(0, 0, side * 0.011), &jaw);
    Place place;
    place.hang(0.4, 1, 25);
    for (int n = 0; n < 25; ++n) place.sheet->m_nodes[n].m_im = 0;
    btMultiBody arm(1, 1, {1, 1, 1}, true, false);
    arm.setBasePos({0, 0, 0});
    arm.setupPrismatic(0, 1, {1, 1, 1}, -1, btQuaternion::getIdentity(), {0, 1, 0}, {0, btScalar(0.97), 0},
                       {0, 0, 0}, true);
    arm.finalizeMultiDof();
    arm.setCanSleep(false);
    place.world.addMultiBody(&arm);
    btMultiBodyLinkCollider hand(&arm, 0);
    hand.setCollisionShape(&jaws);
    hand.setWorldTransform(at(0, 0.97, 0));
    hand.setFriction(1);
    place.world.addCollisionObject(&hand, 2, 1 + 2);
    arm.getLink(0).m_collider = &hand;
    btMultiBodyJointMotor motor(&arm, 0, 0, btScalar(1e4));
    place.world.addMultiBodyConstraint(&motor);
    const auto held = [&] {
        int count = 0;
        for (int n = 0; n < place.sheet->m_nodes.size(); ++n) {
            const btVector3 local = hand.getWorldTransform().invXform(place.sheet->m_nodes[n].m_x).absolute();
            if (local.x() < btScalar(0.03) && local.y() < btScalar(0.03) && local.z() < btScalar(0.01))
                ++count;
        }
        return count;
    };
    place.step(60);
    for (int n = 0; n < 25; ++n)
        place.sheet->m_nodes[n].m_im = btScalar(1e4);  // let go; Drench sets the mass
    place.step(60);
    const int before = held();
    EXPECT_GE(before, 8);
    for (const double speed : {0.5, 0.0}) {
        motor.setVelocityTarget(btScalar(speed));
        place.step(60);
        EXPECT_EQ(held(), before) << speed;
    }
    EXPECT_GT(double(hand.getWorldTransform().getOrigin().y()), 1.4);
    // A motor holds a velocity only: what the weight of wet cloth moved it by in each step would add up.
    place.cloth->soakPores(0.2);
    const btScalar height = hand.getWorldTransform().getOrigin().y();
    place.step(600);
    EXPECT_EQ(held(), before);
    EXPECT_NEAR(double(hand.getWorldTransform().getOrigin().y() - height), 0, 1e-3);
    place.world.removeMultiBodyConstraint(&motor);
    place.world.removeCollisionObject(&hand);
    place.world.removeMultiBody(&arm);
}

TEST(OtherWorlds, ASleepingMultiBodyWakesUnderCloth) {
    btBoxShape box({btScalar(0.1), btScalar(0.1), btScalar(0.1)});
    Place place;
    place.world.setGravity({0, 0, 0});
    btMultiBody body(0, btScalar(0.1), {btScalar(1e-3), btScalar(1e-3), btScalar(1e-3)}, false, true);
    body.finalizeMultiDof();
    place.world.addMultiBody(&body);
    btMultiBodyLinkCollider collider(&body, -1);
    collider.setCollisionShape(&box);
    collider.setWorldTransform(at(0, 0, 0));
    place.world.addCollisionObject(&collider, 2, 1 + 2);
    body.setBaseCollider(&collider);
    place.step(200);
    ASSERT_FALSE(body.isAwake());
    place.lay(0.3, {0, btScalar(0.2), 0}, 9);
    place.step(60);
    EXPECT_LT(double(body.getBasePos().y()), -0.01) << "the cloth presses it down";
    place.cloth.reset();
    place.world.removeSoftBody(place.sheet.get());
    place.sheet.reset();
    place.world.removeCollisionObject(&collider);
    place.world.removeMultiBody(&body);
}

// --- Jumps

// A sheet that hangs on a kinematic ball.
struct Cape {
    Place place;
    btSphereShape shape{btScalar(0.1)};
    btRigidBody& torso;

    Cape() : torso(place.add(shape, at(0, 0.2, 0.2), true)) {
        place.hang(0.4, 0.4, 7);
        for (int n = 0; n < 7; ++n) place.sheet->appendAnchor(n, &torso, false, 1);
        place.step(120);
    }
    // Checks strain, speed and place in the next second.
    void expectCalm(const btVector3& from, const btVector3& way) {
        const double hanging = place.cloth->health().largestStrain;
        double strain = 0, speed = 0;
        place.step(60, [&] {
            strain = std::max(strain, place.cloth->health().largestStrain);
            speed = std::max(speed, place.fastest());
        });
        EXPECT_LT(strain, hanging + 0.01);
        EXPECT_LT(speed, 0.05);
        EXPECT_LT(double((place.sheet->m_nodes[20].m_x - from - way).length()), 0.01);
    }
};

TEST(OtherWorlds, ACapeFollowsATorsoThatJumps) {
    for (const double distance : {1.0, 20.0}) {
        Cape cape;
        const btVector3 from = cape.place.sheet->m_nodes[20].m_x;
        cape.torso.getMotionState()->setWorldTransform(at(distance, 0.2, 0.2));
        cape.expectCalm(from, {btScalar(distance), 0, 0});
    }
}

TEST(OtherWorlds, ASheetThatWasMovedWithItsSolidsDoesNotTakeItForMotion) {
    for (const double distance : {0.2, 1.0, 20.0}) {
        Cape cape;
        const btVector3 from = cape.place.sheet->m_nodes[20].m_x;
        cape.torso.getMotionState()->setWorldTransform(at(distance, 0.2, 0.2));
        cape.place.sheet->transform(at(distance, 0, 0));
        cape.expectCalm(from, {btScalar(distance), 0, 0});
    }
}

TEST(OtherWorlds, JumpedSaysSoForTheRest) {
    // A ball that comes by 0.3 m in a frame pushes a hanging sheet, unless the application says that it has jumped.
    for (const bool says : {false, true}) {
        Place place;
        btSphereShape shape{btScalar(0.1)};
        btRigidBody& ball = place.add(shape, at(0, 0.1, 0.2), true);
        place.hang(0.4, 0.4, 7);
        for (int n = 0; n < 7; ++n) place.sheet->m_nodes[n].m_im = 0;
        place.step(120);
        ball.getMotionState()->setWorldTransform(at(0, 0.1, -0.2));
        if (says) place.cloth->jumped();
        place.step(1);
        if (says)
            EXPECT_LT(place.fastest(), 0.2);
        else
            EXPECT_GT(place.fastest(), 2);
    }
}

}  // namespace
}  // namespace drench::other_worlds_test
