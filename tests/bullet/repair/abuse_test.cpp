// Whatever an application does to a sheet: it stays finite, its memory bounded and its ledger closed, or it says why not.
#include <array>
#include <fstream>
#include <limits>
#include <map>
#include <random>

#include "bullet/world/any_world.h"

namespace drench::abuse_test {
namespace {

using test::AnyWorld;
using test::Mover;

constexpr auto nan = std::numeric_limits<btScalar>::quiet_NaN();

void expectSound(AnyWorld& rig) {
    EXPECT_TRUE(rig.cloth().health().finite);
    EXPECT_LT(test::ledgerError(rig.cloth()), 1e-12);
}

// Memory of the process that is in use, bytes.
std::size_t residentMemory() {
    std::ifstream file("/proc/self/statm");
    std::size_t all = 0, resident = 0;
    file >> all >> resident;
    return resident * 4096;
}

TEST(Abuse, SubstepsOfAnyLength) {
    constexpr int variableStep = 0;
    for (const Mover mover : {Mover::smallSteps, Mover::stock})
        for (const double dt : {1e-6, 1e-5, 0.1, 0.5, 2.0}) {
            SCOPED_TRACE(std::string(test::nameOf(mover)) + ", " + std::to_string(dt));
            AnyWorld rig(mover);
            rig.cloth().soakFilm(0.2);
            rig.cloth().air().wind = {0, 0, 3};
            for (int i = 0; i < 20; ++i) rig.world().stepSimulation(btScalar(dt), variableStep);
            for (int i = 0; i < 20; ++i) rig.world().stepSimulation(btScalar(1.0 / 60), variableStep);
            expectSound(rig);
            // With the stock solver cloth that is thrown about by such steps passes through itself.
            for (const TroubleReport& report : rig.cloth().troubles())
                EXPECT_TRUE(mover == Mover::stock && report.what == Trouble::crossing) << report.message;
        }
}

TEST(Abuse, SubstepsThatAreNoTimeAreRefusedWithNothingChanged) {
    SheetSettings settings;
    settings.stepping = Stepping::byApplication;
    AnyWorld rig(Mover::smallSteps, settings);
    rig.cloth().soakFilm(0.2);
    rig.cloth().preSubstep(btScalar(0.01));
    const double pores = rig.cloth().moisture().totalPoreMass();
    for (const btScalar dt : {btScalar(0), btScalar(-1), nan, std::numeric_limits<btScalar>::infinity()})
        EXPECT_THROW(rig.cloth().preSubstep(dt), std::invalid_argument) << dt;
    EXPECT_EQ(rig.cloth().moisture().totalPoreMass(), pores);
    rig.cloth().preSubstep(btScalar(1e-9));
    expectSound(rig);
    EXPECT_GE(rig.cloth().moisture().totalPoreMass(), pores);
    // Bullet takes no step of no length; one of 1e-9 s has a length in double precision only.
    AnyWorld byWorld(Mover::smallSteps);
    byWorld.world().stepSimulation(0, 0);
    EXPECT_EQ(byWorld.cloth().times().substeps, 0);
    byWorld.world().stepSimulation(btScalar(1e-9), 0);
    expectSound(byWorld);
    EXPECT_THROW(byWorld.world().stepSimulation(nan, 0), std::invalid_argument);
    byWorld.run(5);
    expectSound(byWorld);
}

TEST(Abuse, GravityAndWindBeyondAllMeasure) {
    for (const Mover mover : {Mover::smallSteps, Mover::stock})
        for (const double strength : {1e3, 9e3, 1e6, 1e30}) {
            SCOPED_TRACE(std::string(test::nameOf(mover)) + ", " + std::to_string(strength));
            AnyWorld rig(mover);
            rig.cloth().soakFilm(0.2);
            rig.run(3);
            rig.info().m_gravity.setValue(0, btScalar(-strength), 0);
            rig.cloth().air().wind = {strength, 0, strength / 2};
            rig.run(30);
            expectSound(rig);
            rig.info().m_gravity.setValue(0, btScalar(-9.81), 0);
            rig.cloth().air().wind.setZero();
            rig.run(60);
            expectSound(rig);
        }
}

TEST(Abuse, WithoutGravity) {
    for (const Mover mover : test::movers) {
        AnyWorld rig(mover);
        rig.info().m_gravity.setZero();
        rig.cloth().soakFilm(0.3);
        rig.cloth().add(Rain(100));
        rig.run(60);
        expectSound(rig);
        EXPECT_TRUE(rig.cloth().troubles().empty());
    }
}

TEST(Abuse, SolidsOfAnyMassMeetTheSheet) {
    for (const double mass : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
        SCOPED_TRACE(mass);
        test::SmallStepWorld rig;
        btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.5, 13, 0));
        for (int i = 0; i < 13; ++i) sheet.m_nodes[i].m_im = sheet.m_nodes[12 * 13 + i].m_im = 0;
        WetCloth& cloth = rig.cover(sheet, fabrics::cottonPlain());
        cloth.soakFilm(0.2);
        btRigidBody& ball = rig.bullet().addBall({0, btScalar(0.2), 0}, 0.05, mass);
        ball.setActivationState(DISABLE_DEACTIVATION);
        rig.run(1);
        EXPECT_TRUE(cloth.health().finite);
        EXPECT_LT(test::ledgerError(cloth), 1e-12);
        EXPECT_TRUE(std::isfinite(ball.getWorldTransform().getOrigin().length()));
        EXPECT_TRUE(cloth.troubles().empty());
    }
}

TEST(Abuse, MassesThatAnApplicationGivesTheBodyCountForNothing) {
    for (const Mover mover : test::movers)
        for (const double mass : {1e-6, 1e6}) {
            AnyWorld rig(mover);
            rig.cloth().soakPores(0.2);
            rig.run(10);
            for (int i = 0; i < 10; ++i) {
                rig.sheet().setTotalMass(btScalar(mass), i % 2 == 0);
                rig.sheet().setMass(40, btScalar(mass));
                rig.run(2);
            }
            rig.run(30);
            expectSound(rig);
            EXPECT_TRUE(rig.cloth().troubles().empty());
            EXPECT_LT(rig.cloth().health().largestStrain, 0.2);
        }
}

TEST(Abuse, ASheetOfAnySizeAnywhere) {
    struct Case {
        double side, distance;
    };
    for (const Case& each : {Case{1e-2, 0}, Case{1e4, 0}, Case{0.5, 1e4}, Case{0.5, 1e6}}) {
        SCOPED_TRACE(std::to_string(each.side) + " m, at " + std::to_string(each.distance));
        test::SmallStepWorld rig;
        const Fabric fabric = fabrics::cottonPlain();
        const auto position = btScalar(each.distance);
        const auto size = btScalar(each.side);
        auto made = makeSheet(rig.info(), fabric, flatCorners({0, 0, 0}, {size, 0, 0}, {0, -size, 0}), 9, 9);
        for (int i = 0; i < 9; ++i) made->m_nodes[i].m_im = 0;
        btSoftBody& sheet = rig.add(std::move(made));
        SheetSettings settings;
        settings.unusualScale = true;
        WetCloth& cloth = rig.cover(sheet, fabric, settings);
        sheet.translate({position, 0, position});
        cloth.soakFilm(0.2);
        cloth.air().wind = {0, 0, 2};
        rig.run(1);
        EXPECT_TRUE(cloth.health().finite);
        EXPECT_LT(test::ledgerError(cloth), 1e-12);
        EXPECT_TRUE(cloth.troubles().empty());
    }
}

TEST(Abuse, SheetsOfATenthOfAMillimetreAreMadeAndSmallerOnesAndTonsOfWaterRefused) {
    const std::map<double, const char*> refusals = {
        {1e-6, "corners that enclose no area"},
        {1e-4, ""},
        {1e-3, ""},
        {1e5, "kg of water for node 0; give a mass from 0 to 1e6 kg"},
        {1e7, "kg of water for node 0; give a mass from 0 to 1e6 kg"}};
    for (const auto& [side, why] : refusals) {
        SCOPED_TRACE(side);
        std::string refusal;
        test::SmallStepWorld rig;
        const auto size = btScalar(side);
        try {
            auto made = makeSheet(rig.info(), fabrics::cottonPlain(),
                                  flatCorners({0, 0, 0}, {size, 0, 0}, {0, -size, 0}), 5, 5);
            btSoftBody& sheet = rig.add(std::move(made));
            WetCloth& cloth = rig.cover(sheet, fabrics::cottonPlain());
            cloth.soakFilm(0.1);
            rig.run(0.2);
            EXPECT_TRUE(cloth.health().finite);
            EXPECT_LT(test::ledgerError(cloth), 1e-12);
        } catch (const std::invalid_argument& problem) {
            refusal = problem.what();
        }
        EXPECT_EQ(refusal.find("drench: "), *why ? 0 : std::string::npos) << refusal;
        EXPECT_NE(refusal.find(why), std::string::npos) << refusal;
    }
}

TEST(Abuse, WhatAnApplicationMayDoToABodyInFlight) {
    using Act = void (*)(AnyWorld&);
    const Act acts[] = {
        [](AnyWorld& rig) {
            rig.sheet().translate({btScalar(0.3), 1, 0});
        },
        [](AnyWorld& rig) {
            rig.sheet().rotate(btQuaternion({0, 1, 0}, 1));
        },
        [](AnyWorld& rig) {
            rig.sheet().scale({btScalar(1.2), btScalar(1.2), btScalar(1.2)});
        },
        [](AnyWorld& rig) {
            rig.sheet().transform(btTransform(btQuaternion({1, 0, 0}, 2), {0, 1, 1}));
        },
        [](AnyWorld& rig) { rig.sheet().setRestLengthScale(btScalar(1.1)); },
        [](AnyWorld& rig) {
            rig.sheet().setVelocity({0, 0, 20});
        },
        [](AnyWorld& rig) {
            rig.sheet().addForce({0, 100, 0});
        },
        [](AnyWorld& rig) { rig.sheet().setPose(false, true); },
        [](AnyWorld& rig) { rig.sheet().m_cfg.piterations = 0; },
        [](AnyWorld& rig) { rig.sheet().m_cfg.piterations = 100; },
        [](AnyWorld& rig) { rig.sheet().m_cfg.timescale = btScalar(1e-3); },
        [](AnyWorld& rig) { rig.sheet().m_cfg.kDP = 1; },
        [](AnyWorld& rig) { rig.sheet().m_bUpdateRtCst = true; },
        [](AnyWorld& rig) { rig.sheet().getCollisionShape()->setMargin(btScalar(0.05)); },
        [](AnyWorld& rig) { rig.sheet().randomizeConstraints(); },
        [](AnyWorld& rig) { rig.sheet().forceActivationState(ISLAND_SLEEPING); },
        [](AnyWorld& rig) { rig.sheet().m_nodes[40].m_im = 0; },
        [](AnyWorld& rig) {
            for (int i = 0; i < 9; ++i) rig.sheet().m_nodes[i].m_im = 1;
        },
    };
    for (const Mover mover : test::movers)
        for (std::size_t act = 0; act < std::size(acts); ++act) {
            SCOPED_TRACE(std::string(test::nameOf(mover)) + ", act " + std::to_string(act));
            AnyWorld rig(mover);
            rig.cloth().soakFilm(0.2);
            rig.run(5);
            acts[act](rig);
            rig.run(60);
            expectSound(rig);
            EXPECT_TRUE(rig.cloth().troubles().empty());
        }
}

TEST(Abuse, RandomActsInRandomOrder) {
    std::mt19937 random(7);
    for (const Mover mover : test::movers)
        for (int round = 0; round < 4; ++round) {
            SCOPED_TRACE(std::string(test::nameOf(mover)) + ", round " + std::to_string(round));
            AnyWorld rig(mover);
            for (int i = 0; i < 60; ++i) {
                btSoftBody& sheet = rig.sheet();
                WetCloth& cloth = rig.cloth();
                const int node = static_cast<int>(random() % 81);
                switch (random() % 14) {
                    case 0:
                        cloth.soakFilm(0.05);
                        break;
                    case 1:
                        cloth.addWater(node, 1e-3, {1, 2, 3});
                        break;
                    case 2:
                        cloth.air().wind = {5, 0, -5};
                        break;
                    case 3:
                        sheet.m_nodes[node].m_v.setX(nan);
                        break;
                    case 4:
                        sheet.m_nodes[node].m_x.setY(nan);
                        break;
                    case 5:
                        sheet.m_nodes[node].m_im = sheet.m_nodes[node].m_im > 0 ? 0 : btScalar(1);
                        break;
                    case 6:
                        sheet.cutLink(node, (node + 1) % 81, btScalar(0.4));
                        break;
                    case 7:
                        sheet.setTotalMass(5);
                        break;
                    case 8:
                        cloth.account("pool").takeFilm(std::size_t(node), 1e-4);
                        break;
                    case 9:
                        cloth.add(TimedSoak({std::size_t(node)}, 1e-3));
                        break;
                    case 10:
                        cloth.takeDrops();
                        break;
                    case 11:
                        cloth.setWaterSpeed(double(random() % 1000));
                        break;
                    case 12:
                        sheet.m_cfg.kDP = nan;
                        break;
                    default:
                        cloth.clearTroubles();
                }
                rig.run(static_cast<int>(random() % 3));
            }
            rig.run(30);
            EXPECT_TRUE(rig.cloth().health().fits || !rig.cloth().troubles().empty());
            expectSound(rig);
        }
}

// What an application's callback works on.
struct Comings {
    AnyWorld* rig;
    std::unique_ptr<btSoftBody> body;
    std::unique_ptr<WetCloth> cloth;
    int calls = 0;
};

void comeAndGo(btDynamicsWorld* world, btScalar) {
    auto& comings = *static_cast<Comings*>(world->getWorldUserInfo());
    auto& soft = static_cast<btSoftRigidDynamicsWorld&>(*world);
    switch (++comings.calls % 4) {
        case 1:
            comings.body = test::hangingSheet(soft.getWorldInfo(), fabrics::silk(), 0.2, 5);
            soft.addSoftBody(comings.body.get());
            break;
        case 2:
            comings.cloth = std::make_unique<WetCloth>(soft, *comings.body, fabrics::silk());
            comings.cloth->soakFilm(0.1);
            break;
        case 3:  // Bullet has already listed it for this substep, so it may not end yet
            soft.removeSoftBody(comings.body.get());
            break;
        default:
            comings.body.reset();  // before its layer
            EXPECT_GT(comings.cloth->waterMass(), 0);
            comings.cloth.reset();
    }
}

TEST(Abuse, BodiesAndLayersComeAndGoInTheApplicationsCallback) {
    for (const Mover mover : {Mover::smallSteps, Mover::stock}) {
        AnyWorld rig(mover);
        Comings comings{&rig, nullptr, nullptr};
        rig.clothOwner().reset();
        constexpr bool preTick = true;
        rig.world().setInternalTickCallback(comeAndGo, &comings, preTick);
        rig.clothOwner() = std::make_unique<WetCloth>(rig.world(), rig.sheet(), fabrics::cottonPlain());
        rig.cloth().soakFilm(0.1);
        rig.run(20);
        EXPECT_EQ(comings.calls, 20);
        expectSound(rig);
        EXPECT_TRUE(rig.cloth().troubles().empty());
    }
}

TEST(Abuse, AHundredSheets) {
    test::SmallStepWorld rig({4, 0.01});
    rig.bullet().addGround(-2);
    const Fabric fabric = fabrics::cottonPlain();
    std::vector<WetCloth*> cloths;
    for (int i = 0; i < 100; ++i) {
        auto sheet = test::hangingSheet(rig.info(), fabric, 0.3, 7);
        const int column = i % 10, row = i / 10;
        sheet->translate({btScalar(column), 0, btScalar(0.04 * row)});
        sheet->m_cfg.collisions |= btSoftBody::fCollision::VF_SS;
        cloths.push_back(&rig.cover(rig.add(std::move(sheet)), fabric));
        cloths.back()->soakFilm(0.002 * i);
    }
    rig.run(0.5);
    for (const WetCloth* cloth : cloths) {
        EXPECT_TRUE(cloth->health().finite);
        EXPECT_TRUE(cloth->troubles().empty());
        EXPECT_LT(test::ledgerError(*cloth), 1e-12);
    }
}

TEST(Abuse, TenHoursOfRainAndSunInTimeLapse) {
    SheetSettings settings;
    settings.waterSpeed = 600;  // a frame is ten seconds
    AnyWorld rig(Mover::smallSteps, settings);
    Rain& rain = rig.cloth().add(Rain(20));
    FallingDrops drops(rig.world());
    drops.add(rig.cloth());
    std::size_t afterAnHour = 0;
    for (int hour = 0; hour < 10; ++hour) {
        rain.intensity = hour % 2 == 0 ? 20 : 0;
        rig.cloth().air().temperature = 20 + 2 * hour;
        rig.cloth().air().wind = {0, 0, 0.5 * (hour % 4)};
        for (int i = 0; i < 360; ++i) {
            rig.run(1);
            drops.step(rig.substep());
        }
        if (hour == 0) afterAnHour = residentMemory();
        ASSERT_LT(test::ledgerError(rig.cloth()), 1e-12) << hour;
    }
    EXPECT_GT(rig.cloth().ledger().evaporated, 0);
    EXPECT_GT(rig.cloth().ledger().dripped, 0);
    EXPECT_TRUE(rig.cloth().health().finite);
    EXPECT_TRUE(rig.cloth().troubles().empty());
    EXPECT_LT(residentMemory(), afterAnHour + (std::size_t{4} << 20));
}

}  // namespace
}  // namespace drench::abuse_test
