// Sheets in a pool: they float, sink, are lifted out, and stay quiet in every world.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "bullet/world/worlds.h"
#include "drench/water.h"
#include "world/deformable_world.h"

namespace drench::pool_world_test {
namespace {

using test::SmallStepWorld;

double meanHeight(const btSoftBody& body) {
    double sum = 0;
    for (int n = 0; n < body.m_nodes.size(); ++n) sum += double(body.m_nodes[n].m_x.y());
    return sum / body.m_nodes.size();
}

double kineticEnergy(const btSoftBody& body) {
    double sum = 0;
    for (int n = 0; n < body.m_nodes.size(); ++n)
        sum += 0.5 * test::mass(body.m_nodes[n]) * double(body.m_nodes[n].m_v.length2());
    return sum;
}

// Pore saturation at which cloth weighs as much as it displaces, 1.
double sinkingSaturation(const Fabric& fabric) {
    const double fibre = fabric.arealDensity / fabric.fibreDensity;
    return (waterDensity * fibre + fabric.poreCapacity() - fabric.arealDensity) / fabric.poreCapacity();
}

TEST(PoolWorld, DryClothIsLighterThanWaterUntilItsPoresAreThreeQuartersFull) {
    const Fabric fabric = fabrics::cottonPlain();
    const double saturation = sinkingSaturation(fabric), expected = -2 * std::log(1 - saturation);
    EXPECT_NEAR(saturation, 0.767, 0.002);
    EXPECT_NEAR(expected, 2.9, 0.02);
    SmallStepWorld rig;
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 0.3, 7, 0));
    for (int n = 0; n < sheet.m_nodes.size(); ++n) sheet.m_nodes[n].m_im = 0;
    SheetSettings settings;
    settings.stepping = Stepping::byApplication;
    WetCloth& cloth = rig.cover(sheet, fabric, settings);
    cloth.add(Pool(0.1));
    double time = 0;
    for (double net = -1; net < 0 && time < 10; time += 0.01) {
        cloth.preSubstep(btScalar(0.01));
        net = (cloth.dryMass() + cloth.waterMass()) * 9.81;
        for (int n = 0; n < sheet.m_nodes.size(); ++n) {
            net -= double(sheet.m_nodes[n].m_f.y());
            sheet.m_nodes[n].m_f.setZero();
        }
    }
    EXPECT_NEAR(time, expected, 0.05);
}

TEST(PoolWorld, DryClothFloatsAndSinksWhenItIsSoaked) {
    for (const double frameTime : {1.0 / 240, 1.0 / 60, 1.0 / 30}) {
        SmallStepWorld rig;
        const Fabric fabric = fabrics::cottonPlain();
        btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 0.3, 7, -0.0005));
        WetCloth& cloth = rig.cover(sheet, fabric);
        cloth.add(Pool(0));
        rig.run(2.5, frameTime);
        EXPECT_GT(meanHeight(sheet), -0.015) << frameTime;
        EXPECT_LT(test::fastest(sheet), 0.03);
        rig.run(4.5, frameTime);
        EXPECT_LT(meanHeight(sheet), -0.03) << frameTime;
        EXPECT_GT(cloth.saturation(24), 0.96);
    }
}

TEST(PoolWorld, ClothThatHardlyWetsLiesStillOnTheWater) {
    for (const double frameTime : {1.0 / 240, 1.0 / 60, 1.0 / 30}) {
        SmallStepWorld rig;
        Fabric fabric = fabrics::polyesterPlain();
        fabric.wettingTime = 1e5;
        btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 0.3, 7, 0.05));
        rig.cover(sheet, fabric).add(Pool(0));
        rig.run(12, frameTime);
        EXPECT_NEAR(meanHeight(sheet), 0, 0.01) << frameTime;
        EXPECT_LT(test::fastest(sheet), 0.02) << frameTime;
    }
}

// A sheet held by its upper edge, which goes up and down.
struct Dipped {
    SmallStepWorld rig;
    btSoftBody& sheet;
    WetCloth& cloth;

    Dipped()
        : sheet(rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 0.3, 9))),
          cloth(rig.cover(sheet, fabrics::cottonPlain())) {
        cloth.air().vapourExchange = 0;
        cloth.add(Pool(0.01));
    }
    void raise(double speed, double time) {
        for (int frame = 0; frame < static_cast<int>(std::lround(time * 60)); ++frame) {
            for (int i = 0; i < 9; ++i) sheet.m_nodes[i].m_x += btVector3(0, btScalar(speed / 60), 0);
            rig.run(1.0 / 60);
        }
    }
};

TEST(PoolWorld, ClothThatIsLiftedOutWeighsItsFibreAndWhatTheLedgerSays) {
    Dipped dipped;
    dipped.rig.run(10);
    const double filmBefore = dipped.cloth.moisture().totalFilmMass();
    EXPECT_NEAR(filmBefore, 0.09 * 2 * waterDensity * retainedFilmThickness, 0.02 * filmBefore);
    dipped.raise(0.5, 1);
    const Ledger out = dipped.cloth.ledger();
    // Landau & Levich at 0.5 m/s draw 92 um a face, of which some has run off already.
    const double carried = dipped.cloth.moisture().totalFilmMass() + out.dripped;
    EXPECT_GT(carried, 0.09 * 2 * waterDensity * 60e-6);
    EXPECT_LT(carried, 0.09 * 2 * waterDensity * 110e-6);
    EXPECT_GT(out.returned, 0.0);  // each time that it slows down

    dipped.rig.run(20);
    const Ledger ledger = dipped.cloth.ledger();
    EXPECT_GT(ledger.dripped, out.dripped);
    EXPECT_LT(std::abs(ledger.imbalance()), 1e-6 * ledger.supplied);
    EXPECT_NEAR(ledger.held, ledger.supplied - ledger.returned - ledger.dripped - ledger.evaporated, 1e-9);
    double weight = 0;
    for (int n = 0; n < dipped.sheet.m_nodes.size(); ++n) {
        const btSoftBody::Node& node = dipped.sheet.m_nodes[n];
        weight += node.m_im > 0 ? test::mass(node) : dipped.cloth.nodeMass(n);
        EXPECT_EQ(node.m_f.length2(), 0);
    }
    EXPECT_NEAR(weight, 0.09 * 0.150 + ledger.held, 1e-6 * weight);
}

// Quiet, in every world ----------------------------------------------------------------------------------

enum class Kind { smallSteps, stock, explicitSteps, implicitSteps };

// A sheet that hangs under water, or lies level and free, in one of the worlds.
struct UnderWater {
    SmallStepSolver solver;
    std::unique_ptr<demo::SceneWorld> world;
    std::unique_ptr<btSoftBody> sheet;
    std::unique_ptr<WetCloth> cloth;

    UnderWater(Kind kind, const Fabric& fabric, double depth, bool isHung) {
        if (kind == Kind::smallSteps) world = std::make_unique<demo::BulletWorld>(&solver);
        if (kind == Kind::stock) world = std::make_unique<demo::BulletWorld>();
        if (!world) {
            auto deformable = std::make_unique<demo::DeformableWorld>();
            deformable->world().setImplicit(kind == Kind::implicitSteps);
            deformable->world().setUseProjection(kind == Kind::implicitSteps);
            world = std::move(deformable);
        }
        sheet = isHung ? test::hangingSheet(world->worldInfo(), fabric, 0.3, 9)
                       : test::levelSheet(world->worldInfo(), fabric, 0.3, 9, 0);
        world->addSoftBody(*sheet);
        cloth = std::make_unique<WetCloth>(world->world(), *sheet, fabric);
        cloth->add(Pool(depth));
    }
    ~UnderWater() {
        cloth.reset();
        world->removeSoftBody(*sheet);
    }
    UnderWater(const UnderWater&) = delete;
    UnderWater& operator=(const UnderWater&) = delete;

    void ruffle() {
        std::mt19937 random(7);
        for (int n = 0; n < sheet->m_nodes.size(); ++n)
            for (int axis = 0; axis < 3 && sheet->m_nodes[n].m_im > 0; ++axis)
                sheet->m_nodes[n].m_v[axis] += btScalar(double(random()) / double(random.max()) - 0.5);
    }
    // @return the highest speed on the way, m/s
    double run(double time, double substep) {
        double highest = 0;
        for (int i = 0; i < static_cast<int>(std::lround(time / substep)); ++i) {
            world->world().stepSimulation(btScalar(substep), 0);
            highest = std::max(highest, test::fastest(*sheet));
        }
        return highest;
    }
};

TEST(PoolWorld, ARuffledSheetComesToRestAtAnyDepthInAnyWorld) {
    for (const Kind kind : {Kind::smallSteps, Kind::stock, Kind::implicitSteps, Kind::explicitSteps})
        for (const double substep : {1.0 / 240, 1.0 / 60, 1.0 / 30})
            for (const double depth : {0.01, 1.0, 100.0}) {
                if (kind == Kind::implicitSteps && substep > 1.0 / 60) continue;  // which are too long there
                if (kind == Kind::explicitSteps && (substep > 1.0 / 240 || depth > 0.5))
                    continue;  // all alike, and slow
                SCOPED_TRACE(testing::Message() << int(kind) << " " << substep << " s, " << depth << " m");
                UnderWater stage(kind, fabrics::cottonPlain(), depth, true);
                const double step =
                    kind == Kind::explicitSteps ? std::min(substep, 0.9 * stage.cloth->stepBound()) : substep;
                stage.cloth->soakPores(fabrics::cottonPlain().poreCapacity());
                stage.ruffle();
                const double before = kineticEnergy(*stage.sheet);
                EXPECT_LT(stage.run(0.3, step), 2);
                const double soon = kineticEnergy(*stage.sheet);
                EXPECT_LT(soon, 0.4 * before);
                EXPECT_LT(stage.run(1.2, step), 1);
                ASSERT_TRUE(test::isFinite(*stage.sheet));
                EXPECT_LT(kineticEnergy(*stage.sheet), 0.1 * before);
            }
}

TEST(PoolWorld, AsleepUnderWaterNothingPilesUpAndClothThatGetsHeavierWakes) {
    UnderWater stage(Kind::smallSteps, fabrics::cottonPlain(), 1, false);
    btSoftBody& sheet = *stage.sheet;
    sheet.setActivationState(ISLAND_SLEEPING);
    stage.run(0.1, 0.01);
    EXPECT_TRUE(sheet.isActive()) << "pores fill";
    stage.run(25, 0.05);
    sheet.setActivationState(ISLAND_SLEEPING);
    test::setVelocity(sheet, {0, 0, 0});
    stage.run(1, 0.05);
    EXPECT_FALSE(sheet.isActive()) << "nothing happens any more";
    for (int n = 0; n < sheet.m_nodes.size(); ++n) EXPECT_EQ(sheet.m_nodes[n].m_f.length2(), 0);
}

TEST(PoolWorld, FloatingClothGoesToSleepWhereTheWorldLetsItAndSinksAfterAll) {
    Fabric fabric = fabrics::cottonPlain();
    fabric.wettingTime = 1e5;
    UnderWater stage(Kind::implicitSteps, fabric, 0, false);
    stage.run(6, 1.0 / 60);
    EXPECT_FALSE(stage.sheet->isActive());
    EXPECT_NEAR(meanHeight(*stage.sheet), 0, 0.01);
    stage.cloth->soakPores(0.2);  // 91 %
    stage.run(4, 1.0 / 60);
    EXPECT_LT(meanHeight(*stage.sheet), -0.02);
}

TEST(PoolWorld, ALevelThatRisesOrFallsWakesWhatSleepsInIt) {
    for (const double change : {0.3, -0.3}) {
        UnderWater stage(Kind::implicitSteps, fabrics::cottonPlain(), 0, false);
        stage.cloth.reset();
        SheetSettings settings;
        settings.waterSpeed = 0;  // so that nothing gets heavier
        stage.cloth =
            std::make_unique<WetCloth>(stage.world->world(), *stage.sheet, fabrics::cottonPlain(), settings);
        auto pool = std::make_unique<Pool>(0);
        Pool& water = *pool;
        stage.cloth->add(std::move(pool));
        stage.run(6, 1.0 / 60);
        ASSERT_FALSE(stage.sheet->isActive());
        EXPECT_NEAR(meanHeight(*stage.sheet), 0, 0.01);
        water.level = change;
        stage.run(3, 1.0 / 60);
        EXPECT_NEAR(meanHeight(*stage.sheet), change, 0.02);
        stage.run(6, 1.0 / 60);
        EXPECT_FALSE(stage.sheet->isActive()) << "and it sleeps again";
    }
}

TEST(PoolWorld, ThickPileThatFloatsHighSoaksAndSinks) {
    SmallStepWorld rig;
    Fabric pile = fabrics::cottonPlain();
    pile.arealDensity = 0.4;
    pile.thickness = 3e-3;
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), pile, 0.3, 7, 0.02));
    rig.cover(sheet, pile).add(Pool(0));
    rig.run(2);
    EXPECT_GT(meanHeight(sheet), -0.01);
    rig.run(12);
    EXPECT_LT(meanHeight(sheet), -0.03);
}

TEST(PoolWorld, ARuffledSheetComesToRestAlsoInWaterOfAFasterTime) {
    for (const double waterSpeed : {100.0, 1000.0})
        for (const double level : {-0.05, 0.01}) {
            SmallStepWorld rig;
            const Fabric fabric = fabrics::cottonPlain();
            btSoftBody& sheet = rig.add(test::hangingSheet(rig.info(), fabric, 0.3, 9));
            SheetSettings settings;
            settings.waterSpeed = waterSpeed;
            WetCloth& cloth = rig.cover(sheet, fabric, settings);
            cloth.soakPores(fabric.poreCapacity());
            cloth.add(Pool(level));
            for (int n = 9; n < 81; ++n) sheet.m_nodes[n].m_v.setZ(n % 2 == 0 ? 1 : -1);
            rig.run(2, 1.0 / 30);
            EXPECT_LT(test::fastest(sheet), 0.02) << waterSpeed << ", " << level;
        }
}

}  // namespace
}  // namespace drench::pool_world_test
