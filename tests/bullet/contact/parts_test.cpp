// Ground and ceilings of several parts, which sheets that a SmallStepSolver moves take for one; and what friction and
// cling do to solids that are light.
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <gtest/gtest.h>

#include <limits>

#include "bullet/world/worlds.h"

namespace drench::parts_test {
namespace {

constexpr double g = 9.81;
const btVector3 half(btScalar(2), btScalar(0.25), btScalar(0.4));

// The same block, four ways: whole, of boxes in one compound, of boxes as bodies of their own, of triangles.
enum class Block { whole, compound, bodies, triangles };
constexpr Block blocks[] = {Block::whole, Block::compound, Block::bodies, Block::triangles};

class BlockWorld {
  public:
    BlockWorld(Block kind, const btTransform& transform, double cell)
        : cell_(btScalar(cell)), box_({cell_ / 2, half.y(), cell_ / 2}), whole_(half) {
        if (kind == Block::whole)
            add(whole_, transform);
        else if (kind == Block::triangles)
            addTriangles(transform);
        else
            addBoxes(kind, transform);
    }
    ~BlockWorld() {
        for (const auto& solid : solids_) rig.world().removeRigidBody(solid.get());
    }

    test::SmallStepWorld rig;

  private:
    void addBoxes(Block kind, const btTransform& transform) {
        for (btScalar x = -half.x() + cell_ / 2; x < half.x(); x += cell_)
            for (btScalar z = -half.z() + cell_ / 2; z < half.z(); z += cell_) {
                const btTransform local(btQuaternion::getIdentity(), {x, 0, z});
                if (kind == Block::bodies)
                    add(box_, transform * local);
                else
                    compound_.addChildShape(local, &box_);
            }
        if (kind == Block::compound) add(compound_, transform);
    }
    void addTriangles(const btTransform& transform) {
        for (const btScalar y : {-half.y(), half.y()})
            for (btScalar x = -half.x(); x < half.x() - cell_ / 2; x += cell_)
                for (btScalar z = -half.z(); z < half.z() - cell_ / 2; z += cell_) {
                    const btVector3 a(x, y, z), b(x + cell_, y, z), c(x + cell_, y, z + cell_),
                        d(x, y, z + cell_);
                    triangles_.addTriangle(a, b, c);
                    triangles_.addTriangle(a, c, d);
                }
        mesh_ = std::make_unique<btBvhTriangleMeshShape>(&triangles_, true);
        add(*mesh_, transform);
    }
    void add(btCollisionShape& shape, const btTransform& transform) {
        solids_.push_back(
            std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &shape)));
        solids_.back()->setWorldTransform(transform);
        solids_.back()->setFriction(1);
        rig.world().addRigidBody(solids_.back().get());
    }

    const btScalar cell_;
    btBoxShape box_, whole_;
    btCompoundShape compound_;
    btTriangleMesh triangles_;
    std::unique_ptr<btBvhTriangleMeshShape> mesh_;
    std::vector<std::unique_ptr<btRigidBody>> solids_;
};

TEST(Parts, GroundOfPartsIsAsSmoothAsOneOfOnePiece) {
    const double angle = 20 * 3.14159265358979 / 180;
    const btTransform slope(btQuaternion({0, 0, 1}, btScalar(angle)), {0, 0, 0});
    for (const Block kind : blocks)
        for (const double friction : {0.0, 0.2}) {
            BlockWorld block(kind, slope, 0.2);
            const Fabric fabric = fabrics::cottonPlain();
            btSoftBody& sheet = block.rig.add(test::levelSheet(block.rig.info(), fabric, 0.4, 21, 0));
            const btScalar margin = sheet.getCollisionShape()->getMargin();
            sheet.transform(
                btTransform(slope.getRotation(), slope * btVector3(btScalar(1.5), half.y() + margin, 0)));
            block.rig.cover(sheet, fabric, test::withoutAir());
            sheet.m_cfg.kDF = btScalar(friction);
            block.rig.run(1);
            const btVector3 down = slope.getBasis() * btVector3(-1, 0, 0);
            const double speed = double(test::momentum(sheet).dot(down)) / test::mass(sheet);
            EXPECT_NEAR(speed / (g * (std::sin(angle) - friction * std::cos(angle))), 1, 0.03)
                << static_cast<int>(kind);
        }
}

TEST(Parts, ACeilingOfPartsHoldsAClothOnce) {
    for (const Block kind : blocks)
        for (const double clingOverWeight : {0.9, 1.1}) {
            constexpr double side = 0.2;
            constexpr int nodes = 21;
            Fabric fabric = fabrics::cottonPlain();
            const double water = 0.6 * fabric.poreCapacity();
            fabric.clingEnergy = clingOverWeight * (fabric.arealDensity + water) * g * side / nodes;
            // The seams of the parts run through the sheet.
            BlockWorld block(kind, btTransform(btQuaternion::getIdentity(), {0, half.y(), 0}), 0.05);
            btSoftBody& sheet = block.rig.add(test::levelSheet(block.rig.info(), fabric, side, nodes, 0));
            sheet.translate({btScalar(0.013), -sheet.getCollisionShape()->getMargin() + btScalar(1e-4), 0});
            WetCloth& cloth = block.rig.cover(sheet, fabric, test::withoutAir());
            cloth.soakPores(water);
            cloth.preSubstep(btScalar(1e-6));
            block.rig.run(0.5);
            if (clingOverWeight > 1)
                EXPECT_GT(test::lowest(sheet), -0.01) << static_cast<int>(kind);
            else
                EXPECT_LT(test::lowest(sheet), -0.3) << static_cast<int>(kind);
        }
}

TEST(Parts, LightSolidsThatSpinAgainstWetClothLoseTheirEnergy) {
    for (const double ballMass : {1e-4, 1e-2}) {
        constexpr double radius = 0.05, spin = 10;
        const Fabric fabric = fabrics::cottonPlain();
        test::SmallStepWorld rig;
        rig.setGravity({0, 0, 0});
        btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 0.4, 9, 0));
        WetCloth& cloth = rig.cover(sheet, fabric, test::withoutAir());
        cloth.soakPores(0.13);
        cloth.preSubstep(btScalar(1e-6));
        const double height = radius + double(sheet.getCollisionShape()->getMargin());
        btRigidBody& ball = rig.bullet().addBall({0, btScalar(height - 1e-4), 0}, radius, ballMass);
        ball.setActivationState(DISABLE_DEACTIVATION);
        ball.setAngularVelocity({0, 0, btScalar(spin)});
        const double start = 0.5 * 0.4 * ballMass * radius * radius * spin * spin;
        double max = 0;
        for (int frame = 0; frame < 120; ++frame) {
            rig.run(1.0 / 60);
            max = std::max(max, 0.5 * ballMass * double(ball.getLinearVelocity().length2()));
        }
        EXPECT_LT(max, start) << ballMass;
    }
}

TEST(Parts, FrictionThatIsNoNumberOrBelowZeroIsNoneAndInfiniteFrictionHolds) {
    for (const double friction : {double(std::numeric_limits<float>::infinity()), std::nan(""), -1.0}) {
        test::SmallStepWorld rig;
        btRigidBody& ground = rig.bullet().addBox({0, btScalar(-0.5), 0}, {2, btScalar(0.5), 2});
        ground.setFriction(btScalar(friction));
        const Fabric fabric = fabrics::cottonPlain();
        btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 0.3, 11, 0.01));
        const WetCloth& cloth = rig.cover(sheet, fabric, test::withoutAir());
        test::setVelocity(sheet, {1, 0, 0});
        rig.run(0.5);
        EXPECT_EQ(cloth.health().heldSubsteps, 0) << friction;
        EXPECT_TRUE(test::isFinite(sheet)) << friction;
        const double speed = double(test::momentum(sheet).x()) / test::mass(sheet);
        EXPECT_NEAR(speed, friction > 0 ? 0 : 1, 0.02) << friction;
    }
}

}  // namespace
}  // namespace drench::parts_test
