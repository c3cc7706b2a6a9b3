#include "drench/wet_cloth.h"

#include <gtest/gtest.h>

#include <limits>

#include "bullet/world/worlds.h"

namespace drench::wet_cloth_test {
namespace {

using test::SheetWorld;

using MakeBody = std::unique_ptr<btSoftBody> (*)(btSoftBodyWorldInfo&);

// Every body that a layer must work on.
class AnyBody : public testing::TestWithParam<MakeBody> {};

std::string nameOfBody(const testing::TestParamInfo<MakeBody>& body) {
    const char* const all[] = {"Sheet", "Patch", "TriangleMesh"};
    return all[body.index];
}

INSTANTIATE_TEST_SUITE_P(Bodies, AnyBody, testing::Values(test::smallSheet, test::patch, test::triangleMesh),
                         nameOfBody);

TEST_P(AnyBody, GainsTheMassOfItsWaterPerNodeAndInTotalAndKeepsItsPins) {
    SheetWorld rig(GetParam());
    btSoftBody& body = rig.sheet();
    std::vector<bool> pinned;
    for (int n = 0; n < body.m_nodes.size(); ++n) pinned.push_back(body.m_nodes[n].m_im == 0);
    SheetSettings settings;
    settings.waterSpeed = 0;  // the water stays on the node that it was given to
    WetCloth cloth(rig.world(), body, fabrics::cottonPlain(), settings);
    std::vector<double> dry;
    for (int n = 0; n < body.m_nodes.size(); ++n) dry.push_back(test::mass(body.m_nodes[n]));

    cloth.soakFilm(0.1);
    for (int n = 0; n < body.m_nodes.size(); n += 3) cloth.addWater(n, 1e-5 * (n + 1), {0, -1, 0});
    rig.bullet().step(1.0 / 60, 8);

    double gained = 0, expected = 0;
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        const double area = cloth.moisture().area(static_cast<std::size_t>(n));
        const double water = 0.1 * area + (n % 3 == 0 ? 1e-5 * (n + 1) : 0);
        expected += water;
        EXPECT_EQ(body.m_nodes[n].m_im == 0, pinned[static_cast<std::size_t>(n)]) << n;
        EXPECT_NEAR(cloth.nodeMass(n), area * 0.150 + water, 1e-6 * cloth.nodeMass(n)) << n;
        if (pinned[static_cast<std::size_t>(n)]) {
            gained += water;  // there, though Bullet does not see it
            continue;
        }
        const double increase = test::mass(body.m_nodes[n]) - dry[static_cast<std::size_t>(n)];
        EXPECT_NEAR(increase, water, 1e-6 * test::mass(body.m_nodes[n])) << n;
        gained += increase;
    }
    EXPECT_NEAR(gained, expected, 1e-6 * expected);
    EXPECT_NEAR(cloth.waterMass(), expected, 1e-9 * expected);
    EXPECT_LT(std::abs(cloth.ledger().imbalance()), 1e-6 * cloth.ledger().supplied);
    EXPECT_TRUE(test::isFinite(body));
}

TEST_P(AnyBody, IsGivenBackAsItWas) {
    SheetWorld rig(GetParam());
    btSoftBody& body = rig.sheet();
    body.m_cfg.kDG = btScalar(0.3);
    body.m_cfg.kLF = btScalar(0.1);
    int mark = 0;
    body.setUserPointer(&mark);
    body.m_tag = &mark;
    body.m_nodes[3].m_tag = &mark;
    body.m_links[5].m_tag = &mark;
    btCollisionShape* shape = body.getCollisionShape();
    shape->setUserPointer(&mark);
    rig.bullet().step(1.0 / 240, 1);  // so that Bullet has set the body up

    const btScalar margin = shape->getMargin();
    std::vector<btScalar> inverseMasses, restLengths, constants;
    std::vector<const btSoftBody::Node*> ends;
    for (int n = 0; n < body.m_nodes.size(); ++n) inverseMasses.push_back(body.m_nodes[n].m_im);
    for (int i = 0; i < body.m_links.size(); ++i) {
        restLengths.push_back(body.m_links[i].m_rl);
        constants.push_back(body.m_links[i].m_c0);
        ends.push_back(body.m_links[i].m_n[0]);
    }
    {
        WetCloth cloth(rig.world(), body, fabrics::cottonPlain());
        EXPECT_EQ(body.m_cfg.kDG, 0);
        EXPECT_EQ(body.getUserPointer(), &mark);
        EXPECT_EQ(body.getCollisionShape()->getUserPointer(), &mark);
        cloth.soakFilm(0.2);
        for (int i = 0; i < 20; ++i) rig.bullet().step(1.0 / 60, 8);
    }
    EXPECT_EQ(body.m_cfg.kDG, btScalar(0.3));
    EXPECT_EQ(body.m_cfg.kLF, btScalar(0.1));
    EXPECT_EQ(body.getCollisionShape(), shape);
    EXPECT_EQ(shape->getMargin(), margin);
    EXPECT_EQ(shape->getUserPointer(), &mark);
    EXPECT_EQ(body.getUserPointer(), &mark);
    EXPECT_EQ(body.m_tag, &mark);
    EXPECT_EQ(body.m_nodes[3].m_tag, &mark);
    EXPECT_EQ(body.m_links[5].m_tag, &mark);
    for (int n = 0; n < body.m_nodes.size(); ++n)
        EXPECT_EQ(body.m_nodes[n].m_im, inverseMasses[static_cast<std::size_t>(n)]) << n;
    for (int i = 0; i < body.m_links.size(); ++i) {
        EXPECT_EQ(body.m_links[i].m_rl, restLengths[static_cast<std::size_t>(i)]) << i;
        EXPECT_EQ(body.m_links[i].m_c0, constants[static_cast<std::size_t>(i)]) << i;
        EXPECT_EQ(body.m_links[i].m_n[0], ends[static_cast<std::size_t>(i)]) << i;
    }
}

TEST_P(AnyBody, KeepsItsRestLengthsBitForBitOverAThousandSteps) {
    SheetWorld rig(GetParam());
    WetCloth cloth(rig.world(), rig.sheet(), fabrics::cottonPlain());
    std::vector<btScalar> restLengths;
    for (int i = 0; i < rig.sheet().m_links.size(); ++i) restLengths.push_back(rig.sheet().m_links[i].m_rl);
    rig.bullet().step(1000.0 / 960, 1000);
    for (int i = 0; i < rig.sheet().m_links.size(); ++i) {
        const btSoftBody::Link& link = rig.sheet().m_links[i];
        EXPECT_EQ(link.m_rl, restLengths[static_cast<std::size_t>(i)]) << i;
        EXPECT_EQ(link.m_c1, link.m_rl * link.m_rl) << i;
    }
}

TEST_P(AnyBody, DoesNotCreepWhenTheApplicationSetsMassesInFlight) {
    SheetWorld rig(GetParam());
    WetCloth cloth(rig.world(), rig.sheet(), fabrics::cottonPlain());
    cloth.soakFilm(0.1);
    std::vector<btScalar> restLengths;
    for (int i = 0; i < rig.sheet().m_links.size(); ++i) restLengths.push_back(rig.sheet().m_links[i].m_rl);
    for (int frame = 0; frame < 120; ++frame) {
        rig.sheet().setMass(40, btScalar(0.5));
        if (frame == 60) rig.sheet().setTotalMass(3);
        rig.bullet().step(1.0 / 60, 8);
    }
    for (int i = 0; i < rig.sheet().m_links.size(); ++i)
        EXPECT_EQ(rig.sheet().m_links[i].m_rl, restLengths[static_cast<std::size_t>(i)]) << i;
    EXPECT_NEAR(test::mass(rig.sheet().m_nodes[40]), cloth.nodeMass(40), 1e-6 * cloth.nodeMass(40));
    EXPECT_TRUE(test::isFinite(rig.sheet()));
}

TEST(WetCloth, HonoursPinsThatComeAndGoWhileRunning) {
    SheetWorld rig(test::smallSheet);
    WetCloth cloth(rig.world(), rig.sheet(), fabrics::cottonPlain());
    rig.bullet().step(0.1, 40);
    const int node = 8 + 17 * 16;
    rig.sheet().setMass(node, 0);
    const btVector3 held = rig.sheet().m_nodes[node].m_x;
    rig.sheet().m_nodes[node].m_v.setZero();
    rig.bullet().step(0.2, 80);
    EXPECT_EQ(rig.sheet().m_nodes[node].m_im, 0);
    EXPECT_LT(double((rig.sheet().m_nodes[node].m_x - held).length()), 1e-6);
    rig.sheet().setMass(node, 1);
    rig.bullet().step(0.1, 40);
    EXPECT_NEAR(test::mass(rig.sheet().m_nodes[node]), cloth.nodeMass(node), 1e-6 * cloth.nodeMass(node));
}

TEST(WetCloth, ArrivingWaterBringsItsMomentum) {
    test::FreeSheet rig(fabrics::cottonPlain());
    btSoftBody::Node& node = rig.sheet().m_nodes[60];
    node.m_v = {0, 1, 0};
    const double before = test::mass(node);
    rig.cloth().addWater(60, 1e-3, {0, -2, 0});
    rig.cloth().addWater(60, 1e-3, {3, 0, 0});
    rig.cloth().preSubstep(btScalar(1.0 / 240));
    // (m v + sum of dm u) / (m + sum of dm), by hand.
    const double after = before + 2e-3;
    EXPECT_NEAR(node.m_v.x(), 1e-3 * 3 / after, 1e-5);
    EXPECT_NEAR(node.m_v.y(), (before * 1 - 1e-3 * 2) / after, 1e-5);
}

TEST(WetCloth, WaterThatMovesWithTheClothLeavesItsVelocityAlone) {
    test::FreeSheet rig(fabrics::cottonPlain());
    rig.cloth().soakFilm(0.3);
    rig.cloth().addWater(60, 1e-3, {0, 2, 0});
    rig.sheet().setVelocity({3, 0, 0});  // after the water was put on, before it takes part
    rig.cloth().preSubstep(btScalar(1.0 / 240));
    EXPECT_EQ(rig.sheet().m_nodes[40].m_v.x(), 3);
    const double carried = 0.45 * 0.01;  // cloth and soaked water of a 10 cm cell
    EXPECT_NEAR(rig.sheet().m_nodes[60].m_v.x(), 3 * carried / (carried + 1e-3), 1e-5);
    EXPECT_NEAR(rig.sheet().m_nodes[60].m_v.y(), 2e-3 / (carried + 1e-3), 1e-5);
}

TEST(WetCloth, PinsFreedWhileItRunsAreGivenBackWhole) {
    SheetWorld rig(test::smallSheet);
    {
        WetCloth cloth(rig.world(), rig.sheet(), fabrics::cottonPlain());
        cloth.soakFilm(0.2);
        rig.bullet().step(0.1, 40);
        for (int i = 0; i < 9; ++i) rig.sheet().m_nodes[i].m_im = 1;
        rig.bullet().step(0.1, 40);
    }
    for (int i = 0; i < rig.sheet().m_links.size(); ++i) {
        const btSoftBody::Link& link = rig.sheet().m_links[i];
        EXPECT_NEAR(link.m_c0, link.m_n[0]->m_im + link.m_n[1]->m_im, 1e-3 * link.m_c0) << i;
    }
    EXPECT_NEAR(test::mass(rig.sheet().m_nodes[5]), 0.150 * 0.5 * 0.5 / 256 / 2, 1e-9);  // dry; on the border
}

TEST(WetCloth, ALayerThatNoOneStepsLeavesAnOrdinaryBody) {
    SheetWorld rig(test::patch);
    SheetSettings settings;
    settings.stepping = Stepping::byApplication;
    const WetCloth cloth(rig.world(), rig.sheet(), fabrics::cottonPlain(), settings);
    rig.bullet().step(2, 2000);
    EXPECT_TRUE(test::isFinite(rig.sheet()));
    EXPECT_LT(test::largestStrain(rig.sheet()), 1);
}

TEST(WetCloth, SoftSoftContactsMayBeSwitchedOnAfterwards) {
    demo::BulletWorld bullet;
    btSoftBodyWorldInfo& info = bullet.world().getWorldInfo();
    const auto level = [&](double y) {
        return makeSheet(info, fabrics::cottonPlain(),
                         flatCorners({0, btScalar(y), 0}, {btScalar(0.4), 0, 0}, {0, 0, btScalar(0.4)}), 17,
                         17);
    };
    const auto lower = level(1), upper = level(1.05);
    for (int n = 0; n < lower->m_nodes.size(); ++n) lower->m_nodes[n].m_im = 0;
    bullet.world().addSoftBody(lower.get());
    bullet.world().addSoftBody(upper.get());
    {
        WetCloth a(bullet.world(), *lower, fabrics::cottonPlain()),
            b(bullet.world(), *upper, fabrics::cottonPlain());
        lower->m_cfg.collisions |= btSoftBody::fCollision::VF_SS;
        upper->m_cfg.collisions |= btSoftBody::fCollision::VF_SS;
        bullet.step(0.5, 120);
        EXPECT_GT(upper->m_nodes[8 + 17 * 8].m_x.y(), 0.98);
    }
    bullet.world().removeSoftBody(lower.get());
    bullet.world().removeSoftBody(upper.get());
}

TEST(WetCloth, AeroThatTheApplicationSetsLaterIsNotDoubledAndNotLost) {
    SheetWorld rig(test::smallSheet);
    {
        WetCloth cloth(rig.world(), rig.sheet(), fabrics::cottonPlain());
        rig.sheet().m_cfg.kDG = btScalar(0.7);
        rig.bullet().step(0.02, 2);
        EXPECT_EQ(rig.sheet().m_cfg.kDG, 0);
    }
    EXPECT_EQ(rig.sheet().m_cfg.kDG, btScalar(0.7));
}

TEST(WetCloth, WaterFollowsTheBodysOwnTime) {
    SheetWorld slow(test::smallSheet), usual(test::smallSheet);
    slow.sheet().m_cfg.timescale = btScalar(0.25);
    WetCloth slowCloth(slow.world(), slow.sheet(), fabrics::cottonPlain());
    WetCloth usualCloth(usual.world(), usual.sheet(), fabrics::cottonPlain());
    slowCloth.soakFilm(1);
    usualCloth.soakFilm(1);
    slow.bullet().step(1.0, 240);
    usual.bullet().step(0.25, 60);
    EXPECT_NEAR(slowCloth.saturation(100), usualCloth.saturation(100), 1e-5);
    slow.sheet().m_cfg.timescale = 0;
    slow.bullet().step(0.01, 1);
    EXPECT_EQ(slow.sheet().m_cfg.timescale, 1);
}

TEST(WetCloth, WaterWakesASleepingSheet) {
    SheetWorld rig(test::smallSheet);
    WetCloth cloth(rig.world(), rig.sheet(), fabrics::cottonPlain());
    rig.sheet().forceActivationState(ISLAND_SLEEPING);
    cloth.air().wind = {0, 0, 5};
    rig.bullet().step(0.1, 10);
    for (int n = 0; n < rig.sheet().m_nodes.size(); ++n)
        EXPECT_EQ(rig.sheet().m_nodes[n].m_f.length2(), 0);  // nothing piles up meanwhile
    cloth.addWater(100, 1e-3);
    EXPECT_TRUE(rig.sheet().isActive());
}

TEST(WetCloth, SeveralSheetsInOneWorldKeepTheirOwnWater) {
    demo::BulletWorld bullet;
    btSoftBodyWorldInfo& info = bullet.world().getWorldInfo();
    const auto cottonSheet = test::hangingSheet(info, fabrics::cottonPlain(), 0.5, 12);
    const auto denimSheet = test::hangingSheet(info, fabrics::denim(), 0.5, 12);
    bullet.world().addSoftBody(cottonSheet.get());
    bullet.world().addSoftBody(denimSheet.get());
    {
        WetCloth cotton(bullet.world(), *cottonSheet, fabrics::cottonPlain());
        auto denim = std::make_unique<WetCloth>(bullet.world(), *denimSheet, fabrics::denim());
        cotton.air().vapourExchange = denim->air().vapourExchange = 0;
        cotton.soakPores(0.1);
        bullet.step(0.1, 40);
        EXPECT_NEAR(cotton.waterMass(), 0.025, 1e-8);
        EXPECT_EQ(denim->waterMass(), 0.0);
        EXPECT_NEAR(denim->dryMass(), 0.324 * 0.25, 1e-6);
        denim.reset();
        bullet.step(0.5, 200);
        EXPECT_GT(cotton.saturation(70), 0.2);  // the other goes on
    }
    bullet.world().removeSoftBody(cottonSheet.get());
    bullet.world().removeSoftBody(denimSheet.get());
}

TEST(WetCloth, WaterSpeedRunsWaterFasterThanMechanics) {
    SheetWorld slow(test::smallSheet), fast(test::smallSheet);
    SheetSettings settings;
    settings.waterSpeed = 10;
    WetCloth slowCloth(slow.world(), slow.sheet(), fabrics::cottonPlain());
    WetCloth fastCloth(fast.world(), fast.sheet(), fabrics::cottonPlain(), settings);
    slowCloth.soakFilm(1);
    fastCloth.soakFilm(1);
    slow.bullet().step(1.0, 240);
    fast.bullet().step(0.1, 24);
    EXPECT_NEAR(fastCloth.saturation(100), slowCloth.saturation(100), 1e-5);
}

TEST(WetCloth, MaterialCoordinatesGiveLinksTheirDirection) {
    // The same patch, once flattened by the layer and once with warp and weft exchanged by the application.
    Fabric unequal = fabrics::cottonPlain();
    unequal.stretchWarp = 4000;
    unequal.stretchWeft = 100;
    double stretch[2];
    for (const bool exchanged : {false, true}) {
        SheetWorld rig(+[](btSoftBodyWorldInfo& info) {
            return test::hangingSheet(info, fabrics::cottonPlain(), 0.5, 11);
        });
        SheetSettings settings;
        for (int n = 0; exchanged && n < rig.sheet().m_nodes.size(); ++n) {
            const int row = n / 11, column = n % 11;
            settings.materialCoordinates.emplace_back(0.05 * row, 0.05 * column);
        }
        WetCloth cloth(rig.world(), rig.sheet(), unequal, settings);
        rig.sheet().m_cfg.kDP = btScalar(0.002);
        cloth.soakFilm(0.8);
        for (int i = 0; i < 60; ++i) rig.bullet().step(1.0 / 60, 32);
        stretch[exchanged ? 1 : 0] = -0.5 - double(rig.sheet().m_nodes[5 + 11 * 10].m_x.y());
    }
    EXPECT_GT(stretch[0], 5 * stretch[1]);  // hangs along the soft weft, then along the stiff warp
}

TEST(WetCloth, SaysWhatItIsMadeOfAndHowMuchLightItLetsThrough) {
    SheetWorld rig(test::smallSheet);
    const Fabric silk = fabrics::silk();
    WetCloth cloth(rig.world(), rig.sheet(), silk);
    EXPECT_EQ(cloth.fabric().name, silk.name);
    EXPECT_DOUBLE_EQ(cloth.transmittance(5), WetLaws(silk).transmittance(0));
    cloth.soakPores(0.5 * silk.poreCapacity());
    EXPECT_NEAR(cloth.saturation(5), 0.5, 1e-6);
    EXPECT_DOUBLE_EQ(cloth.transmittance(5), WetLaws(silk).transmittance(cloth.saturation(5)));
}

TEST(WetCloth, RefusesInputThatIsNotFiniteBeforeBulletSeesIt) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    SheetWorld rig(test::smallSheet);
    WetCloth cloth(rig.world(), rig.sheet(), fabrics::cottonPlain(), test::throwing());
    EXPECT_THROW(cloth.addWater(0, nan), std::invalid_argument);
    EXPECT_THROW(cloth.addWater(0, -1), std::invalid_argument);
    EXPECT_THROW(cloth.addWater(-1, 1e-3), std::out_of_range);
    EXPECT_THROW(cloth.addWater(100000, 1e-3), std::out_of_range);
    EXPECT_THROW(cloth.addWater(0, 1e-3, {btScalar(nan), 0, 0}), std::invalid_argument);
    EXPECT_THROW(cloth.soakFilm(nan), std::invalid_argument);
    EXPECT_THROW(cloth.soakFilm(1e39), std::invalid_argument);
    EXPECT_THROW(cloth.addWater(0, 1e39), std::invalid_argument);
    EXPECT_THROW(cloth.saturation(289), std::out_of_range);
    EXPECT_THROW(cloth.nodeMass(-1), std::out_of_range);
    EXPECT_THROW(cloth.gloss(289), std::out_of_range);
    EXPECT_THROW(cloth.transmittance(289), std::out_of_range);
    EXPECT_EQ(cloth.waterMass(), 0.0);

    cloth.air().wind = {0, nan, 0};
    EXPECT_THROW(rig.bullet().step(1.0 / 60, 1), std::runtime_error);
    cloth.air().wind.setZero();
    rig.sheet().m_nodes[20].m_v.setY(btScalar(nan));
    try {
        rig.bullet().step(1.0 / 60, 1);
        FAIL() << "let a velocity that is not finite through";
    } catch (const std::runtime_error& problem) {
        EXPECT_NE(std::string(problem.what()).find("node 20"), std::string::npos);
    }
    rig.sheet().m_nodes[20].m_v.setZero();
    rig.bullet().step(1.0 / 60, 4);
    EXPECT_TRUE(test::isFinite(rig.sheet()));
}

TEST(WetCloth, SaysSoWhenTheBodyIsNoClothAnyMore) {
    SheetWorld rig(test::smallSheet);
    WetCloth cloth(rig.world(), rig.sheet(), fabrics::cottonPlain(), test::throwing());
    rig.bullet().step(1.0 / 60, 4);
    rig.sheet().appendLink(0, 1);
    EXPECT_THROW(rig.bullet().step(1.0 / 60, 1), std::runtime_error);
}

TEST(WetCloth, SteppingByTheApplicationIsTheApplicationsAlone) {
    SheetWorld rig(test::smallSheet);
    SheetSettings settings;
    settings.stepping = Stepping::byApplication;
    WetCloth cloth(rig.world(), rig.sheet(), fabrics::cottonPlain(), settings);
    cloth.soakFilm(0.1);
    rig.bullet().step(1.0, 240);
    EXPECT_EQ(cloth.moisture().totalPoreMass(), 0.0);
    cloth.preSubstep(btScalar(0.01));
    EXPECT_GT(cloth.moisture().totalPoreMass(), 0.0);
    EXPECT_THROW(cloth.preSubstep(0), std::invalid_argument);
    EXPECT_THROW(cloth.preSubstep(std::numeric_limits<btScalar>::quiet_NaN()), std::invalid_argument);

    SheetWorld other(test::smallSheet);
    WetCloth byWorld(other.world(), other.sheet(), fabrics::cottonPlain());
    EXPECT_THROW(byWorld.preSubstep(btScalar(0.01)), std::logic_error);
}

}  // namespace
}  // namespace drench::wet_cloth_test
