// Wet friction, cling and penetration of sheets in Bullet's deformable world.
#include <gtest/gtest.h>

#include <string>

#include "wet_contact_rig.h"
#include "world/deformable_world.h"

namespace drench::deformable_contact_test {
namespace {

using test::gravity;
using test::WetContactRig;

constexpr int nodes = 7;

enum class Mode { explicitSteps, implicitSteps };

std::unique_ptr<demo::SceneWorld> deformableWorld(Mode mode) {
    auto world = std::make_unique<demo::DeformableWorld>();
    world->world().setImplicit(mode == Mode::implicitSteps);
    world->world().setUseProjection(mode == Mode::implicitSteps);
    return world;
}

// Substeps a second that the cloth's step bound asks for, or that implicit contacts do.
int substepsFor(WetCloth& cloth, Mode mode) {
    return mode == Mode::implicitSteps ? 240 : static_cast<int>(std::ceil(1 / cloth.stepBound()));
}

class DeformableContact : public testing::TestWithParam<Mode> {};

TEST_P(DeformableContact, FrictionIsCoulombs) {
    const auto after1Second = [](double friction) {
        WetContactRig rig(deformableWorld(GetParam()), nodes, fabrics::cottonPlain());
        rig.layOnSlope();
        rig.sheet().m_cfg.kDF = btScalar(2 * friction);
        const int substeps = substepsFor(rig.cover(0), GetParam());
        const btVector3 from = test::centre(rig.sheet());
        rig.run(1, substeps);
        return std::pair(rig.speedDown(), rig.distanceDown(from));
    };
    const double slides = gravity * (std::sin(test::slope) - 0.2 * std::cos(test::slope));
    EXPECT_NEAR(after1Second(0.2).first / slides, 1, 0.03);
    EXPECT_NEAR(after1Second(0.4).second, 0, 1e-3);
}

TEST_P(DeformableContact, WaterHoldsClothOnASlopeAndMoreWaterLetsItGo) {
    Fabric fabric = fabrics::polyesterPlain();
    fabric.clingEnergy = 0;
    const auto speed = [&](double saturation) {
        WetContactRig rig(deformableWorld(GetParam()), nodes, fabric);
        const btRigidBody& box = rig.layOnSlope();
        WetCloth& cloth = rig.cover(saturation);
        cloth.setSurface(box, SurfaceKind::plate);
        rig.run(1, substepsFor(cloth, GetParam()));
        return rig.speedDown();
    };
    const auto expected = [&](double friction) {
        return gravity * (std::sin(test::slope) - friction * std::cos(test::slope));
    };
    EXPECT_NEAR(speed(0) / expected(fabric.plateFrictionDry), 1, 0.03);
    EXPECT_NEAR(speed(0.6), 0, 1e-3);
    EXPECT_NEAR(speed(4) / expected(fabric.plateFrictionSoaked), 1, 0.1);
}

TEST_P(DeformableContact, AWetSheetHangsOnACeilingWhileItsBondExceedsItsWeight) {
    for (const double fraction : {0.9, 1.1}) {
        WetContactRig rig(deformableWorld(GetParam()), nodes, test::cottonThatClings(fraction));
        rig.pressAgainstCeiling();
        rig.run(1, substepsFor(rig.cover(0.6), GetParam()));
        if (fraction > 1) {
            EXPECT_GT(test::lowest(rig.sheet()), -double(rig.margin()) - 2e-3);
        } else {
            EXPECT_LT(double(test::centre(rig.sheet()).y()), -1.5) << "as far as bonds break";
        }
    }
}

TEST_P(DeformableContact, ASheetThatClingsToAFreePlateDrawsItAlong) {
    for (const double plateMass : {0.02, 0.5}) {
        WetContactRig rig(deformableWorld(GetParam()), nodes, fabrics::cottonPlain());
        // Without the force of gravity.
        rig.world().world().setGravity({0, 0, 0});
        rig.world().removeSoftBody(rig.sheet());
        static_cast<demo::DeformableWorld&>(rig.world()).world().addSoftBody(&rig.sheet());
        const btRigidBody& plate = rig.pressAgainstPlate(plateMass);
        const int substeps = substepsFor(rig.cover(0.6), GetParam());
        const auto total = [&] {
            return test::momentum(rig.sheet()) + plate.getLinearVelocity() * btScalar(plateMass);
        };
        rig.run(0.2, substeps);
        const btVector3 pull(0, btScalar(-0.3), 0);
        test::setVelocity(rig.sheet(), pull);
        for (int n = 0; n < rig.sheet().m_nodes.size(); ++n) rig.sheet().m_nodes[n].m_vn = pull;
        const btVector3 pulled = total();
        rig.run(0.5, substeps);
        if (GetParam() == Mode::implicitSteps) {
            // Bullet's implicit contacts do not keep momentum, with a layer or without.
            EXPECT_LT(double(plate.getLinearVelocity().y()), -0.03) << plateMass;
            continue;
        }
        EXPECT_LT(double((total() - pulled).length()), 0.01 * double(pulled.length())) << plateMass;
        EXPECT_NEAR(double(plate.getLinearVelocity().y()),
                    double(pulled.y()) / (plateMass + test::mass(rig.sheet())), 0.05)
            << plateMass;
    }
}

TEST_P(DeformableContact, ASheetThatIsThrownAtABallStaysOutside) {
    WetContactRig rig(deformableWorld(GetParam()), 17, fabrics::cottonPlain());
    constexpr double radius = 0.25, depth = 0.3;
    rig.world().addBall({0, btScalar(-depth), 0}, radius, 0);
    const int substeps = substepsFor(rig.cover(0), GetParam());
    test::setVelocity(rig.sheet(), {0, -5, 0});
    double deepest = 0;
    for (int i = 0; i < substeps / 4; ++i) {
        rig.run(1.0 / substeps, substeps);
        for (int n = 0; n < rig.sheet().m_nodes.size(); ++n) {
            const btVector3 fromCentre = rig.sheet().m_nodes[n].m_x + btVector3(0, btScalar(depth), 0);
            deepest = std::max(deepest, radius - double(fromCentre.length()));
        }
    }
    // Bullet's implicit solve knows no contacts that come only in the solve.
    EXPECT_LT(deepest, GetParam() == Mode::explicitSteps ? 1e-3 : 0.02);
}

INSTANTIATE_TEST_SUITE_P(BothModes, DeformableContact,
                         testing::Values(Mode::explicitSteps, Mode::implicitSteps), [](const auto& mode) {
                             return std::string(mode.param == Mode::explicitSteps ? "Explicit" : "Implicit");
                         });

}  // namespace
}  // namespace drench::deformable_contact_test
