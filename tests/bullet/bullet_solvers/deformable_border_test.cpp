// What the deformable world refuses, several sheets in it, and who ends first.
#include <gtest/gtest.h>

#include <string>

#include "bullet/world/body_fields.h"
#include "deformable_rig.h"

namespace drench::deformable_border_test {
namespace {

using namespace test;

class SeveralSheets : public testing::TestWithParam<Mode> {};
INSTANTIATE_TEST_SUITE_P(Deformable, SeveralSheets,
                         testing::Values(Mode::explicitSteps, Mode::implicitSteps));

std::string errorOf(DeformableWorld& bullet, double dt) {
    try {
        bullet.step(dt, 1);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

TEST(DeformableWorld, RefusesStepsThatWouldBlowUp) {
    DeformableWorld bullet(Mode::explicitSteps);
    const Fabric fabric = constantStiffness(100);
    const auto sheet = test::hangingSheet(bullet.info(), fabric, side, nodesAlongEdge);
    bullet.add(*sheet);
    {
        WetCloth cloth(bullet.world(), *sheet, fabric);
        const double bound = cloth.stepBound();
        const double cellMass = cloth.dryMass() / ((nodesAlongEdge - 1) * (nodesAlongEdge - 1));
        RecordProperty("k_dt2_over_m", std::to_string(100 * bound * bound / cellMass));
        EXPECT_GT(100 * bound * bound / cellMass, 0.15);
        EXPECT_LT(100 * bound * bound / cellMass, 0.30);

        const btVector3 before = sheet->m_nodes[100].m_x;
        EXPECT_NE(errorOf(bullet, 1.0 / 60).find("27 substeps for a frame of 1/60 s"), std::string::npos)
            << errorOf(bullet, 1.0 / 60);
        EXPECT_EQ(sheet->m_nodes[100].m_x, before);
        EXPECT_EQ(errorOf(bullet, bound), "");

        cloth.soakFilm(0.2);  // heavier, but it will dry
        EXPECT_EQ(errorOf(bullet, bound), "");
        EXPECT_EQ(cloth.stepBound(), bound);
        EXPECT_NE(errorOf(bullet, 1.1 * bound), "");

        bullet.world().setImplicit(true);
        EXPECT_NE(errorOf(bullet, bound).find("setUseProjection"), std::string::npos);
        bullet.world().setUseProjection(true);
        EXPECT_EQ(errorOf(bullet, 1.0 / 60), "");
        EXPECT_TRUE(std::isinf(cloth.stepBound()));
    }
    bullet.world().removeSoftBody(sheet.get());
}

TEST(DeformableWorld, TheBoundIsNotFarFromWhereStepsBlowUp) {
    const Fabric fabric = constantStiffness(100);
    for (const double times : {1.0, 2.0}) {
        DeformableWorld bullet(Mode::explicitSteps);
        const auto sheet = test::hangingSheet(bullet.info(), fabric, side, nodesAlongEdge);
        for (int n = 0; n < nodesAlongEdge; ++n) sheet->m_nodes[n].m_im = 1;
        bullet.add(*sheet);
        {
            SheetSettings settings;
            settings.stepping = Stepping::byApplication;
            WetCloth cloth(bullet.world(), *sheet, fabric, settings);
            cloth.preSubstep(btScalar(1e-5));  // the only one, so that nothing refuses what follows
            sheet->m_nodes[100].m_v.setX(btScalar(0.01));
            bullet.step(200 * times * cloth.stepBound(), 200);
            if (times > 1)
                EXPECT_GT(largestExtension(*sheet), 0.5);
            else
                EXPECT_LT(largestExtension(*sheet), 0.01);
        }
        bullet.world().removeSoftBody(sheet.get());
    }
}

TEST(DeformableWorld, OtherWorldsAreRefused) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld rigid(&dispatcher, &broadphase, &solver, &configuration);
    demo::BulletWorld bullet;
    const auto sheet = test::smallSheet(bullet.world().getWorldInfo());
    try {
        const WetCloth cloth(rigid, *sheet, fabrics::cottonPlain());
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("btDeformableMultiBodyDynamicsWorld"), std::string::npos);
    }
    EXPECT_THROW(const FallingDrops drops(rigid), std::invalid_argument);
}

TEST(DeformableWorld, PlanesAreRefused) {
    DeformableWorld bullet(Mode::explicitSteps);
    const auto sheet = test::smallSheet(bullet.info());
    btStaticPlaneShape plane({0, 1, 0}, 0);
    btCollisionObject ground;
    ground.setCollisionShape(&plane);
    bullet.world().addCollisionObject(&ground);
    EXPECT_THROW(const WetCloth cloth(bullet.world(), *sheet, fabrics::cottonPlain()), std::invalid_argument);
    bullet.world().removeCollisionObject(&ground);
}

TEST(DeformableWorld, AnchorsFollowTheMass) {
    DeformableWorld bullet(Mode::explicitSteps);
    const Fabric fabric = constantStiffness(100);
    const auto sheet = test::hangingSheet(bullet.info(), fabric, side, nodesAlongEdge);
    for (int n = 0; n < nodesAlongEdge; ++n) sheet->m_nodes[n].m_im = 1;
    btRigidBody& ball = bullet.addBall({0, 1, 0}, 0.1);
    bullet.add(*sheet);
    sheet->appendDeformableAnchor(0, &ball);
    sheet->appendDeformableAnchor(nodesAlongEdge - 1, &ball);
    const btVector3 held = sheet->m_nodes[0].m_x;
    const int substeps = 27;
    {
        WetCloth cloth(bullet.world(), *sheet, fabric);
        cloth.soakPores(0.3);
        for (int i = 0; i < 30; ++i) bullet.step(1.0 / 60, substeps);
        EXPECT_EQ(sheet->m_deformableAnchors[0].m_c2, sheet->m_nodes[0].m_im);
        EXPECT_NEAR(1 / double(sheet->m_nodes[0].m_im), cloth.nodeMass(0), 1e-9);
        EXPECT_LT(double((sheet->m_nodes[0].m_x - held).length()), 1e-4);
        EXPECT_LT(largestExtension(*sheet), 0.5);
    }
    EXPECT_EQ(sheet->m_deformableAnchors[0].m_c2, sheet->m_nodes[0].m_im);
    bullet.world().removeSoftBody(sheet.get());
}

TEST_P(SeveralSheets, TwoSheetsAndOneOfAnotherKind) {
    DeformableWorld bullet(GetParam());
    const auto hang = [&](double stretch, double z) {
        auto sheet = test::hangingSheet(bullet.info(), constantStiffness(stretch), side, nodesAlongEdge);
        pinCorners(*sheet);
        sheet->translate({0, 0, btScalar(z)});
        bullet.add(*sheet);
        return sheet;
    };
    const auto plain = hang(50, -0.3), soft = hang(20, 0), stiff = hang(100, 0.3);
    for (int n = 0; n < plain->m_nodes.size(); ++n)
        if (plain->m_nodes[n].m_im > 0) plain->m_nodes[n].m_im = btScalar(1 / 1.5e-4);
    btDeformableMassSpringForce springs(50, btScalar(0.01), true, 0);
    bullet.world().addForce(plain.get(), &springs);
    {
        SheetSettings settings;
        settings.waterSpeed = 0;
        WetCloth softCloth(bullet.world(), *soft, constantStiffness(20), settings);
        WetCloth stiffCloth(bullet.world(), *stiff, constantStiffness(100), settings);
        const double dt = longestStep(stiffCloth);
        for (double time = 0; time < 1.5; time += dt) {
            bullet.step(dt, 1);
            for (const btSoftBody* sheet : {plain.get(), soft.get(), stiff.get()})
                for (int n = 0; n < sheet->m_nodes.size(); ++n)
                    const_cast<btSoftBody*>(sheet)->m_nodes[n].m_v *= btScalar(1 - 10 * dt);
        }
        EXPECT_EQ(bullet.wetForces(), 2);
        EXPECT_NEAR(outcomeOf(*soft).sag, atRest(constantStiffness(20), 0).sag, 5e-4);
        EXPECT_NEAR(outcomeOf(*stiff).sag, atRest(constantStiffness(100), 0).sag, 1e-4);
        EXPECT_GT(outcomeOf(*plain).sag, 0.001);
        EXPECT_LT(largestExtension(*plain), 0.5);
        bullet.world().removeSoftBody(soft.get());
        EXPECT_EQ(bullet.wetForces(), 1);
        bullet.step(dt, 5);
        EXPECT_NEAR(outcomeOf(*stiff).sag, atRest(constantStiffness(100), 0).sag, 1e-4);
    }
    EXPECT_EQ(bullet.wetForces(), 0);
    bullet.step(1e-4, 1);
    bullet.world().removeSoftBody(stiff.get());
    bullet.world().removeSoftBody(plain.get());
}

// The three things whose order of ending is free. Each ends once.
struct Ending {
    DeformableWorld bullet{Mode::explicitSteps};
    std::unique_ptr<btSoftBody> body =
        test::hangingSheet(bullet.info(), constantStiffness(100), side, nodesAlongEdge);
    std::unique_ptr<WetCloth> cloth;
    std::vector<double> fields;
    double water = 0;

    Ending() {
        bullet.add(*body);
        body->updateConstants();  // as Bullet does in its next step
        fields = test::changedFields(*body);
        cloth = std::make_unique<WetCloth>(bullet.world(), *body, constantStiffness(100));
        cloth->soakFilm(0.1);
        step();
        EXPECT_EQ(bullet.wetForces(), 1);
        EXPECT_NE(test::changedFields(*body), fields);
        water = cloth->waterMass();
    }
    void step() { bullet.step(0.002, 5); }
    void removeBody() { bullet.world().removeSoftBody(body.get()); }
};

TEST(DeformableLifetime, ClothFirst) {
    for (const bool worldBeforeBody : {true, false}) {
        Ending ending;
        ending.cloth.reset();
        EXPECT_EQ(ending.bullet.wetForces(), 0);
        ending.step();
        if (worldBeforeBody) {
            ending.bullet.end();
        } else {
            ending.removeBody();
            ending.body.reset();
            ending.step();
        }
    }
}

TEST(DeformableLifetime, BodyFirst) {
    for (const bool worldBeforeCloth : {true, false}) {
        Ending ending;
        ending.removeBody();
        EXPECT_EQ(ending.bullet.wetForces(), 0);
        ending.body.reset();
        ending.step();
        if (worldBeforeCloth) ending.bullet.end();
        ending.cloth.reset();
        if (!worldBeforeCloth) ending.step();
    }
}

TEST(DeformableLifetime, WorldFirst) {
    for (const bool bodyBeforeCloth : {true, false}) {
        Ending ending;
        ending.bullet.end();
        if (bodyBeforeCloth) ending.body.reset();
        EXPECT_EQ(ending.cloth->waterMass(), ending.water);
        ending.cloth.reset();
        if (!bodyBeforeCloth) {
            EXPECT_EQ(test::changedFields(*ending.body), ending.fields);
        }
    }
}

TEST(DeformableLifetime, ABodyThatLeavesAndComesBackGoesOn) {
    Ending ending;
    ending.removeBody();
    ending.step();
    ending.bullet.add(*ending.body);
    ending.step();
    EXPECT_EQ(ending.bullet.wetForces(), 1);
    ending.removeBody();
    ending.cloth.reset();
    EXPECT_EQ(ending.bullet.wetForces(), 0);
}

TEST(DeformableLifetime, AnotherClothForTheSameBody) {
    Ending ending;
    ending.cloth.reset();
    ending.cloth = std::make_unique<WetCloth>(ending.bullet.world(), *ending.body, constantStiffness(100));
    ending.step();
    EXPECT_EQ(ending.bullet.wetForces(), 1);
    ending.bullet.world().removeSoftBodyForce(ending.body.get());  // the application takes all forces away
    ending.step();
    EXPECT_EQ(ending.bullet.wetForces(), 1);
    ending.removeBody();
}

TEST(DeformableLifetime, AttachedBeforeItIsInTheWorld) {
    DeformableWorld bullet(Mode::implicitSteps);
    const auto sheet = test::hangingSheet(bullet.info(), constantStiffness(100), side, nodesAlongEdge);
    WetCloth cloth(bullet.world(), *sheet, constantStiffness(100));
    bullet.step(1.0 / 60, 1);
    EXPECT_EQ(bullet.wetForces(), 0);
    bullet.add(*sheet);
    bullet.step(1.0 / 60, 1);
    EXPECT_EQ(bullet.wetForces(), 1);
    bullet.world().removeSoftBody(sheet.get());
}

TEST(DeformableLifetime, SteppedByTheApplication) {
    DeformableWorld bullet(Mode::explicitSteps);
    const auto sheet = test::hangingSheet(bullet.info(), constantStiffness(100), side, nodesAlongEdge);
    bullet.add(*sheet);
    {
        SheetSettings settings;
        settings.stepping = Stepping::byApplication;
        WetCloth cloth(bullet.world(), *sheet, constantStiffness(100), settings);
        EXPECT_THROW(cloth.preSubstep(btScalar(1.0 / 60)), std::runtime_error);
        cloth.preSubstep(btScalar(1e-4));
        bullet.step(1e-4, 1);
        EXPECT_EQ(bullet.wetForces(), 1);
    }
    EXPECT_EQ(bullet.wetForces(), 0);
    bullet.world().removeSoftBody(sheet.get());
}

}  // namespace
}  // namespace drench::deformable_border_test
