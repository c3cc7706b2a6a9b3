// Whether weight shows as it should, against a solver that shares nothing with Bullet or the library.
#include <gtest/gtest.h>

#include "bullet/world/worlds.h"
#include "hanging_grid.h"

namespace drench::mechanics_test {
namespace {

using test::constantStiffness;
using test::Outcome;

constexpr int nodes = 17;
constexpr double side = 0.5;

bool hangsByCorners(int node) {
    return node < 2 || (node >= nodes - 2 && node < nodes);
}

// Lets a sheet with `water` times its own mass of water come to rest in Bullet.
Outcome inBullet(const Fabric& fabric, double water, double dt) {
    demo::BulletWorld bullet;
    const auto sheet = test::hangingSheet(bullet.world().getWorldInfo(), fabric, side, nodes);
    for (int n = 0; n < nodes; ++n)
        if (!hangsByCorners(n)) sheet->m_nodes[n].m_im = 1;  // only the corners hold it
    bullet.world().addSoftBody(sheet.get());
    SheetSettings settings;
    settings.waterSpeed = 0;  // the solver knows no water that runs down
    WetCloth cloth(bullet.world(), *sheet, fabric, settings);
    cloth.soakPores(water * fabric.arealDensity);
    sheet->m_cfg.kDP = btScalar(3 * dt);
    constexpr double duration = 5;  // s
    bullet.step(duration, static_cast<int>(duration / dt));

    Outcome outcome{-side - double(sheet->m_nodes[nodes / 2 + nodes * (nodes - 1)].m_x.y()), 0};
    outcome.meanStrain = test::meanStrain(*sheet);
    bullet.world().removeSoftBody(sheet.get());
    return outcome;
}

// The same sheet put together from the textile formulas alone and solved at rest in double precision.
Outcome atRest(const Fabric& fabric, double water) {
    const auto problem =
        test::hangingGrid(fabric, side, nodes, fabric.arealDensity * (1 + water), hangsByCorners);
    const auto x = test::solveStatic(problem);
    return {-side - x[std::size_t(nodes / 2 + nodes * (nodes - 1))].y(), test::meanStrain(problem, x)};
}

TEST(Mechanics, SagAndStrainGrowWithWeightAsAtRestInAnIndependentSolver) {
    const Fabric fabric = constantStiffness(60);
    constexpr double dt = 1.0 / 960;
    {  // the substep resolves the stiffness
        demo::BulletWorld bullet;
        const auto sheet = test::hangingSheet(bullet.world().getWorldInfo(), fabric, side, nodes);
        const WetCloth cloth(bullet.world(), *sheet, fabric);
        ASSERT_GE(cloth.stepBound(), dt);
    }
    const Outcome single = inBullet(fabric, 0, dt);
    for (const int times : {1, 2, 3}) {
        const Outcome found = inBullet(fabric, times - 1, dt), expected = atRest(fabric, times - 1);
        RecordProperty("sag_error_" + std::to_string(times), std::to_string(found.sag / expected.sag - 1));
        EXPECT_NEAR(found.sag / expected.sag, 1, 0.04) << times << " times the mass";
        EXPECT_NEAR(found.meanStrain / expected.meanStrain, 1, 0.04) << times << " times the mass";
        EXPECT_NEAR(found.meanStrain / single.meanStrain, times, 0.10 * times);
        std::printf("%d x mass: sag %.5f m, at rest %.5f m; mean strain %.5f, at rest %.5f\n", times,
                    found.sag, expected.sag, found.meanStrain, expected.meanStrain);
    }
}

TEST(Mechanics, DryingByHalfInOneStepDoesNotBlowUp) {
    // A body whose masses fall to less than half between two substeps: the application makes a new, dry
    // layer.
    test::SheetWorld rig(test::smallSheet);
    {
        WetCloth soaked(rig.world(), rig.sheet(), fabrics::cottonPlain());
        soaked.soakFilm(0.35);
        for (int i = 0; i < 30; ++i) rig.bullet().step(1.0 / 60, 16);
    }
    double before = 0;
    for (int n = 0; n < rig.sheet().m_nodes.size(); ++n) before += test::mass(rig.sheet().m_nodes[n]);
    WetCloth dry(rig.world(), rig.sheet(), fabrics::cottonPlain());
    dry.air().vapourExchange = 0;
    for (int i = 0; i < 120; ++i) {
        rig.bullet().step(1.0 / 60, 16);
        ASSERT_LT(test::largestStrain(rig.sheet()), 0.2) << "frame " << i;
    }
    double after = 0;
    for (int n = 0; n < rig.sheet().m_nodes.size(); ++n) after += test::mass(rig.sheet().m_nodes[n]);
    EXPECT_NEAR(after, before, 1e-6);
}

TEST(Mechanics, SixtyFourSquaredWithBulletsDefaultsSurvivesTenSeconds) {
    const auto survives = [](std::unique_ptr<btSoftBody> sheet, demo::BulletWorld& bullet) {
        bullet.world().addSoftBody(sheet.get());
        ASSERT_EQ(sheet->m_cfg.piterations, 1);
        WetCloth cloth(bullet.world(), *sheet, fabrics::cottonPlain());
        cloth.soakFilm(0.1);
        bullet.step(10, 600);
        EXPECT_TRUE(test::isFinite(*sheet));
        for (int n = 0; n < sheet->m_nodes.size(); ++n)
            ASSERT_LT(double((sheet->m_nodes[n].m_x - sheet->m_nodes[0].m_x).length()), 200) << n;
        bullet.world().removeSoftBody(sheet.get());
    };
    {
        demo::BulletWorld bullet;
        survives(test::hangingSheet(bullet.world().getWorldInfo(), fabrics::cottonPlain(), 2, 64), bullet);
    }
    {  // Bullet's own patch, whose links come in mesh order
        demo::BulletWorld bullet;
        btSoftBodyWorldInfo& info = bullet.world().getWorldInfo();
        info.m_sparsesdf.setDefaultVoxelsz(btScalar(0.02));
        info.m_sparsesdf.Reset();
        std::unique_ptr<btSoftBody> body(btSoftBodyHelpers::CreatePatch(
            info, {-1, 0, -1}, {1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, 64, 64, 1 + 2, true));
        body->getCollisionShape()->setMargin(btScalar(0.01));
        survives(std::move(body), bullet);
    }
}

}  // namespace
}  // namespace drench::mechanics_test
