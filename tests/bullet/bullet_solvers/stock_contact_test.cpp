// Wet friction, cling and penetration of sheets that Bullet's own solver moves, and the post-tick slot.
#include <gtest/gtest.h>

#include "wet_contact_rig.h"

namespace drench::stock_contact_test {
namespace {

using test::gravity;
using test::WetContactRig;

constexpr int nodes = 13;
constexpr int substeps = 240;  // a second

std::unique_ptr<demo::SceneWorld> stockWorld() {
    return demo::makeWorld(demo::WorldKind::softRigid, demo::SolverKind::stock);
}

void endGravity(demo::SceneWorld& world) {
    world.world().setGravity({0, 0, 0});
    world.worldInfo().m_gravity = {0, 0, 0};
}

TEST(StockContact, FrictionIsCoulombsWithAnySubstepsAndSweeps) {
    for (const int sweeps : {1, 4})
        for (const int each : {60, 240, 480}) {
            const auto after2Seconds = [&](double friction) {
                WetContactRig rig(stockWorld(), nodes, fabrics::cottonPlain());
                rig.layOnSlope();
                rig.sheet().m_cfg.kDF = btScalar(2 * friction);
                rig.sheet().m_cfg.piterations = sweeps;
                rig.cover(0);
                const btVector3 from = test::centre(rig.sheet());
                rig.run(2, each);
                return std::pair(rig.speedDown(), rig.distanceDown(from));
            };
            const double slides = 2 * gravity * (std::sin(test::slope) - 0.2 * std::cos(test::slope));
            EXPECT_NEAR(after2Seconds(0.2).first / slides, 1, 0.03) << sweeps << " sweeps, " << each;
            EXPECT_NEAR(after2Seconds(0.4).second, 0, 1e-3) << sweeps << " sweeps, " << each;
        }
}

TEST(StockContact, WaterHoldsClothOnASlopeAndMoreWaterLetsItGo) {
    Fabric fabric = fabrics::polyesterPlain();
    fabric.clingEnergy = 0;
    const auto speed = [&](double saturation) {
        WetContactRig rig(stockWorld(), nodes, fabric);
        const btRigidBody& box = rig.layOnSlope();
        rig.cover(saturation).setSurface(box, SurfaceKind::plate);
        rig.run(1, substeps);
        return rig.speedDown();
    };
    const auto expected = [&](double friction) {
        return gravity * (std::sin(test::slope) - friction * std::cos(test::slope));
    };
    EXPECT_NEAR(speed(0) / expected(fabric.plateFrictionDry), 1, 0.03);
    EXPECT_NEAR(speed(0.6), 0, 1e-3);
    EXPECT_NEAR(speed(4) / expected(fabric.plateFrictionSoaked), 1, 0.03);
}

TEST(StockContact, AWetSheetHangsOnACeilingWhileItsBondExceedsItsWeight) {
    for (const Stepping stepping : {Stepping::byWorld, Stepping::byApplication})
        for (const double fraction : {0.9, 1.1}) {
            WetContactRig rig(stockWorld(), nodes, test::cottonThatClings(fraction));
            rig.pressAgainstCeiling();
            WetCloth& cloth = rig.cover(0.6, stepping);
            for (int i = 0; i < 2 * substeps; ++i) {
                if (stepping == Stepping::byApplication) cloth.preSubstep(btScalar(1.0 / substeps));
                rig.run(1.0 / substeps, substeps);
            }
            if (fraction > 1) {
                EXPECT_GT(test::lowest(rig.sheet()), -double(rig.margin()) - 1e-3);
            } else {
                EXPECT_LT(double(test::centre(rig.sheet()).y()), -5) << "as far as bonds break";
            }
        }
}

TEST(StockContact, DrySheetsDoNotHang) {
    WetContactRig rig(stockWorld(), nodes, test::cottonThatClings(2));
    rig.pressAgainstCeiling();
    rig.cover(0);
    rig.run(1, substeps);
    EXPECT_LT(double(test::centre(rig.sheet()).y()), -1);
}

TEST(StockContact, ASheetThatClingsToAFreePlateDrawsItAlong) {
    for (const double plateMass : {0.02, 0.5}) {
        WetContactRig rig(stockWorld(), nodes, fabrics::cottonPlain());
        endGravity(rig.world());
        const btRigidBody& plate = rig.pressAgainstPlate(plateMass);
        rig.cover(0.6);
        const auto total = [&] {
            return test::momentum(rig.sheet()) + plate.getLinearVelocity() * btScalar(plateMass);
        };
        rig.run(1.0 / substeps, substeps);  // in which the sheet gets the mass of its water
        const btVector3 before = total();
        rig.run(0.3, substeps);
        EXPECT_LT(double((total() - before).length()), 0.01 * double(before.length())) << plateMass;

        test::setVelocity(rig.sheet(), {0, btScalar(-0.3), 0});
        const btVector3 pulled = total();
        rig.run(0.5, substeps);
        EXPECT_LT(double((total() - pulled).length()), 0.01 * double(pulled.length())) << plateMass;
        EXPECT_NEAR(double(plate.getLinearVelocity().y()),
                    double(pulled.y()) / (plateMass + test::mass(rig.sheet())), 0.05)
            << plateMass;
    }
}

TEST(StockContact, ASolidThatIsGoneHoldsNothing) {
    WetContactRig rig(stockWorld(), nodes, test::cottonThatClings(3));
    {
        btBoxShape shape({1, btScalar(0.5), 1});
        const auto box =
            std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &shape));
        box->setWorldTransform(
            btTransform(btQuaternion::getIdentity(), {0, btScalar(0.5) + rig.margin(), 0}));
        rig.world().world().addRigidBody(box.get());
        test::setVelocity(rig.sheet(), {0, btScalar(0.2), 0});
        rig.cover(0.6);
        rig.run(0.5, substeps);
        EXPECT_NEAR(double(test::centre(rig.sheet()).y()), 0, 1e-3);
        rig.world().world().removeRigidBody(box.get());
    }
    rig.run(1, substeps);
    EXPECT_LT(double(test::centre(rig.sheet()).y()), -1);
}

// Deepest that a sheet thrown at a ball of 0.25 m ever is inside it, m.
double deepestInBall(int substepsPerSecond, int sweeps) {
    WetContactRig rig(stockWorld(), 21, fabrics::cottonPlain());
    constexpr double radius = 0.25, depth = 0.3;
    rig.world().addBall({0, btScalar(-depth), 0}, radius, 0);
    rig.sheet().m_cfg.piterations = sweeps;
    rig.cover(0);
    test::setVelocity(rig.sheet(), {0, -5, 0});
    double deepest = 0;
    for (int i = 0; i < substepsPerSecond; ++i) {
        rig.run(1.0 / substepsPerSecond, substepsPerSecond);
        for (int n = 0; n < rig.sheet().m_nodes.size(); ++n) {
            const btVector3 fromCentre = rig.sheet().m_nodes[n].m_x + btVector3(0, btScalar(depth), 0);
            deepest = std::max(deepest, radius - double(fromCentre.length()));
        }
    }
    return deepest;
}

TEST(StockContact, NoNodeEndsFarInsideABall) {
    EXPECT_LT(deepestInBall(240, 1), 1e-3);
    EXPECT_LT(deepestInBall(240, 4), 1e-3);
    EXPECT_LT(deepestInBall(60, 10), 0.01);
}

TEST(StockContact, ASheetThatHangsOverAnEdgeDoesNotCreep) {
    // A quarter of it hangs over, so that friction of more than a third holds it.
    const auto crept = [](double friction) {
        WetContactRig rig(stockWorld(), nodes, fabrics::cottonPlain());
        const btScalar top = -rig.margin();
        rig.world().addBox({btScalar(-1 + 0.125), top - btScalar(0.5), 0}, {1, btScalar(0.5), 1});
        rig.sheet().m_cfg.kDF = btScalar(2 * friction);
        rig.cover(0);
        rig.sheet().m_cfg.kDP = btScalar(0.01);
        rig.run(2, substeps);
        const btVector3 from = test::centre(rig.sheet());
        rig.run(2, substeps);
        return double((test::centre(rig.sheet()) - from).length());
    };
    EXPECT_LT(crept(0.7), 2e-3);
    EXPECT_GT(crept(0.1), 0.1);
}

// The post-tick slot, which the layer borrows ---------------------------------------------------------------

struct Application {
    int calls = 0;
    std::unique_ptr<WetCloth>* toEnd = nullptr;
};

void applicationCallback(btDynamicsWorld* world, btScalar) {
    auto* application = static_cast<Application*>(world->getWorldUserInfo());
    ++application->calls;
    if (application->toEnd) application->toEnd->reset();
}

struct Slot : btDynamicsWorld {
    static btInternalTickCallback of(btDynamicsWorld& world) {
        return world.*(&Slot::m_internalTickCallback);
    }
};

TEST(StockContact, ASheetThatLiesMayBeMovedByTheApplication) {
    for (const double saturation : {0.0, 0.6}) {
        WetContactRig rig(stockWorld(), nodes, fabrics::cottonPlain());
        rig.world().addGround(-rig.margin());
        rig.cover(saturation);
        rig.run(0.2, substeps);
        const btVector3 from = test::centre(rig.sheet());
        rig.sheet().translate({1, 0, 0});
        rig.run(0.05, substeps);
        EXPECT_NEAR(double((test::centre(rig.sheet()) - from).x()), 1, 1e-3) << saturation;
    }
}

TEST(PostTick, TheApplicationsCallbackAndUserInfoGoOnWorking) {
    WetContactRig rig(stockWorld(), nodes, fabrics::cottonPlain());
    Application application;
    rig.cover(0);
    rig.run(0.1, 100);
    EXPECT_EQ(Slot::of(rig.world().world()), nullptr);
    rig.world().world().setInternalTickCallback(applicationCallback, &application);
    rig.run(0.1, 100);
    EXPECT_EQ(application.calls, 10);
    EXPECT_EQ(Slot::of(rig.world().world()), applicationCallback);
    EXPECT_EQ(rig.world().world().getWorldUserInfo(), &application);
    rig.owner().reset();
    rig.run(0.1, 100);
    EXPECT_EQ(application.calls, 20);
}

TEST(PostTick, ALayerMayEndWithinTheApplicationsCallback) {
    WetContactRig rig(stockWorld(), nodes, fabrics::cottonPlain());
    rig.layOnSlope();
    rig.cover(0.6);
    Application application{0, &rig.owner()};
    rig.world().world().setInternalTickCallback(applicationCallback, &application);
    rig.run(0.1, 100);
    EXPECT_EQ(rig.owner(), nullptr);
    EXPECT_TRUE(test::isFinite(rig.sheet()));
}

TEST(PostTick, AWorldMayEndBeforeALayerThatWaitsForIt) {
    for (const auto kind : {demo::WorldKind::softRigid, demo::WorldKind::deformable}) {
        WetContactRig rig(demo::makeWorld(kind, demo::SolverKind::stock), 5, fabrics::cottonPlain());
        WetCloth& cloth = rig.cover(0.6, Stepping::byApplication);
        cloth.preSubstep(btScalar(1e-4));  // and the step never comes
        EXPECT_NE(Slot::of(rig.world().world()), nullptr);
        rig.endWorld();
    }
    // Others may take the worlds' places in memory.
    WetContactRig after(stockWorld(), nodes, fabrics::cottonPlain());
    after.cover(0.6);
    after.run(0.1, substeps);
    EXPECT_TRUE(test::isFinite(after.sheet()));
}

}  // namespace
}  // namespace drench::stock_contact_test
