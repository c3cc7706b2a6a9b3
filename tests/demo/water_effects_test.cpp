// Whether rain, drops and sprays fall, land, wet and dry as they should, in real Bullet worlds.
#include "effects/water_effects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "stage/scene_cloth.h"
#include "world/angles.h"
#include "world/scene_world.h"

namespace drench::demo::water_effects_test {
namespace {

constexpr double frameTime = 1.0 / 60;
const Eigen::Vector3d downwards(0, -6.5, 0);

Eigen::AlignedBox3d region(double halfSide, double height) {
    return {Eigen::Vector3d(-halfSide, 0, -halfSide), Eigen::Vector3d(halfSide, height, halfSide)};
}

std::unique_ptr<SceneWorld> worldWithGround() {
    auto world = makeWorld(WorldKind::softRigid, SolverKind::smallStep);
    world->addGround(0);
    return world;
}

viewer::Picture pictureOf(const WaterEffects& effects) {
    viewer::Picture picture;
    effects.show(picture);
    return picture;
}

SheetDescription sheetOf(const Eigen::Vector3d& corner, const Eigen::Vector3d& warp,
                         const Eigen::Vector3d& weft, int nodes) {
    SheetDescription sheet;
    sheet.corner = corner;
    sheet.warp = warp;
    sheet.weft = weft;
    sheet.nodes = {nodes, nodes};
    return sheet;
}

TEST(WaterEffects, DropsThatLandLeaveWetPlacesThere) {
    const auto world = worldWithGround();
    SceneCloth cloth(*world, sheetOf({-0.2, 0.8, 0}, {0.4, 0, 0}, {0, -0.4, 0}, 9), 1);
    for (int i = 0; i < 9; ++i) cloth.node(i, 0).m_im = 0;
    cloth.wet().soakPores(2 * fabrics::cottonPlain().poreCapacity());
    FallingDrops drops(world->world());
    drops.add(cloth.wet());
    WaterEffects effects(world->world());
    std::size_t landings = 0;
    bool seenInFlight = false;
    for (int frame = 0; frame < 600 && landings < 5; ++frame) {
        world->step(frameTime, 1);
        drops.step(frameTime);
        effects.follow(drops);
        const viewer::Picture picture = pictureOf(effects);
        seenInFlight =
            seenInFlight || (!drops.inFlight().empty() && picture.drops.size() >= drops.inFlight().size());
        for (const FallingDrops::Landing& landing : drops.landed()) {
            ++landings;
            double nearest = 1e9;
            for (const viewer::WetPatch& patch : picture.patches)
                nearest =
                    std::min(nearest, (patch.centre.cast<double>() - landing.position).norm() / patch.radius);
            EXPECT_LT(nearest, 1);
        }
    }
    EXPECT_GE(landings, 5u);
    EXPECT_TRUE(seenInFlight);
    EXPECT_NEAR(effects.spots().mass(), drops.massElsewhere(), 1e-3 * drops.massElsewhere());
}

TEST(WetSpots, MoveAndTurnWithTheirBody) {
    const auto world = worldWithGround();
    btRigidBody& ball = world->addBall({0, 1, 0}, 0.3, 0);
    WetSpots spots(10);
    spots.wet(ball, {0, 1.3, 0}, 1e-4, 0.5f);
    ball.setWorldTransform(btTransform(btQuaternion({0, 0, 1}, btScalar(pi / 2)), {2, 1, 0}));
    viewer::Picture picture;
    spots.show(picture);
    ASSERT_EQ(picture.patches.size(), 1u);
    EXPECT_LT((picture.patches[0].centre - Eigen::Vector3f(1.7f, 1, 0)).norm(), 1e-5f);
    EXPECT_NEAR(std::abs(picture.patches[0].orientation.z()), std::sin(pi / 4), 1e-5);
}

TEST(WetSpots, RunTogetherGrowAndHaveAThinLayersArea) {
    const auto world = worldWithGround();
    const btRigidBody& ball = world->addBall({0, 1, 0}, 0.3, 0);
    WetSpots spots(10);
    spots.wet(ball, {0, 1.3, 0}, 50e-6, 0.5f);
    viewer::Picture one, two;
    spots.show(one);
    EXPECT_NEAR(pi * std::pow(double(one.patches.at(0).radius), 2) * WetSpots::layer, 50e-6, 1e-8);
    spots.wet(ball, {0.002, 1.3, 0}, 50e-6, 0.1f);
    spots.show(two);
    ASSERT_EQ(two.patches.size(), 1u);
    EXPECT_NEAR(two.patches[0].radius / one.patches[0].radius, std::sqrt(2), 1e-3);
    spots.wet(ball, {0.1, 1.28, 0}, 50e-6, 0.1f);
    EXPECT_EQ(spots.size(), 2u);
}

TEST(WetSpots, TheDriestGoWhenThereIsNoRoomAndAllGoWithTheirBody) {
    const auto world = worldWithGround();
    btRigidBody& ball = world->addBall({0, 1, 0}, 0.3, 0);
    WetSpots spots(2);
    spots.wet(ball, {0.3, 1, 0}, 50e-6, 0);
    spots.dry(0.5 * WetSpots::layer);
    spots.wet(ball, {0, 1.3, 0}, 50e-6, 0);
    spots.wet(ball, {-0.3, 1, 0}, 50e-6, 0);
    viewer::Picture picture;
    spots.show(picture);
    ASSERT_EQ(picture.patches.size(), 2u);
    for (const viewer::WetPatch& patch : picture.patches) EXPECT_LT(patch.centre.x(), 0.1f);
    world->world().removeRigidBody(&ball);
    spots.keepOnlyIn(world->world());
    EXPECT_EQ(spots.size(), 0u);
    EXPECT_THROW(WetSpots(0), std::invalid_argument);
}

TEST(WaterEffects, APlaceDriesInTheTimeOfItsLayerAtTheRateOfTheAir) {
    const auto world = worldWithGround();
    WaterEffects effects(world->world());
    effects.rain(1, downwards, region(0.3, 2));
    while (effects.spots().size() == 0) effects.step(frameTime, Air());
    effects.rain(0, downwards, region(0.3, 2));
    Air still;
    still.vapourExchange = 0;
    for (int frame = 0; frame < 60; ++frame) effects.step(frameTime, still);
    ASSERT_TRUE(pictureOf(effects).streaks.empty());
    Air air;
    air.wind = {2, 0, 0};
    constexpr double waterSpeed = 60;
    const double time = WetSpots::layer / (evaporation(air, 2, 0.5).rate / 2) / waterSpeed;
    effects.step(0.9 * time, air, waterSpeed);
    ASSERT_GT(effects.spots().size(), 0u);
    for (const viewer::WetPatch& patch : pictureOf(effects).patches) EXPECT_LT(patch.wetness, 0.99f);
    // Where two drops fell into one place there may be up to two layers.
    effects.step(1.15 * time, air, waterSpeed);
    EXPECT_EQ(effects.spots().size(), 0u);
}

TEST(WaterEffects, OpenGroundGetsWetAsFastAsTheRainFallsAndDriesAgain) {
    const auto world = worldWithGround();
    WaterEffects effects(world->world());
    for (int frame = 0; frame < 600; ++frame) {
        effects.rain(60, downwards, region(0.3, 1));
        effects.step(frameTime, Air());
    }
    const viewer::OpenGround wet = pictureOf(effects).openGround;
    EXPECT_NEAR(wet.covered, 1 - std::exp(-OpenGround::withinOutline * 60 / 360 / WetSpots::layer), 0.02);
    EXPECT_EQ(wet.wetness, 1);
    EXPECT_LT((wet.from - Eigen::Vector2f(-0.3f, -0.3f)).norm(), 1e-6f);
    EXPECT_LT((wet.to - Eigen::Vector2f(0.3f, 0.3f)).norm(), 1e-6f);
    effects.rain(0, downwards, region(0.3, 1));
    Air air;
    air.wind = {2, 0, 0};
    const double time = WetSpots::layer / (evaporation(air, 2, 0.5).rate / 2);
    effects.step(0.9 * time, air);
    EXPECT_GT(pictureOf(effects).openGround.covered, 0);
    effects.step(1.2 * time, air);
    EXPECT_EQ(pictureOf(effects).openGround.covered, 0);
}

TEST(WaterEffects, CountsStayWithinTheirLimits) {
    const auto world = worldWithGround();
    WaterEffectsLimits limits;
    limits.streaks = 50;
    limits.drops = 40;
    limits.puffs = 5;
    limits.spots = 30;
    WaterEffects effects(world->world(), limits);
    effects.rain(100, downwards, region(2, 3));
    for (int frame = 0; frame < 600; ++frame) {
        Nozzle nozzle;
        nozzle.position = {0, 1, 0};
        nozzle.direction = {0.3, -0.2, 1};
        effects.spray(nozzle);
        effects.step(frameTime, Air());
        const viewer::Picture picture = pictureOf(effects);
        ASSERT_LE(picture.streaks.size(), limits.streaks + limits.drops);
        ASSERT_LE(picture.drops.size(), 2 * limits.drops);
        ASSERT_LE(picture.mist.size(), limits.puffs);
        ASSERT_LE(picture.patches.size(), limits.spots);
    }
    const viewer::Picture picture = pictureOf(effects);
    EXPECT_GT(picture.streaks.size(), limits.streaks / 2);
    EXPECT_FALSE(picture.drops.empty());
    EXPECT_FALSE(picture.mist.empty());
    EXPECT_EQ(picture.patches.size(), limits.spots);
}

std::vector<Eigen::Vector3f> spotsAfterASecond(unsigned seed) {
    const auto world = worldWithGround();
    WaterEffectsLimits limits;
    limits.seed = seed;
    WaterEffects effects(world->world(), limits);
    effects.rain(30, {1, -6, 0}, region(1, 3));
    for (int frame = 0; frame < 60; ++frame) {
        effects.spray({});
        effects.step(frameTime, Air());
    }
    const viewer::Picture picture = pictureOf(effects);
    std::vector<Eigen::Vector3f> all;
    for (const viewer::Streak& streak : picture.streaks) all.push_back(streak.from);
    for (const viewer::WaterDrop& drop : picture.drops) all.push_back(drop.centre);
    for (const viewer::MistPuff& puff : picture.mist) all.push_back(puff.centre);
    for (const viewer::WetPatch& patch : picture.patches) all.push_back(patch.centre);
    return all;
}

TEST(WaterEffects, TheSameSeedShowsTheSamePicture) {
    const std::vector<Eigen::Vector3f> one = spotsAfterASecond(1);
    EXPECT_GT(one.size(), 500u);
    EXPECT_EQ(one, spotsAfterASecond(1));
    EXPECT_NE(one, spotsAfterASecond(2));
}

TEST(WaterEffects, UnderARoofNothingFalls) {
    const auto world = worldWithGround();
    world->addBox({0, 2, 0}, {0.5, 0.05f, 0.5});
    WaterEffects effects(world->world());
    effects.rain(60, downwards, region(1.2, 3));
    bool aboveRoof = false, onRoof = false, inTheOpen = false;
    for (int frame = 0; frame < 240; ++frame) {
        effects.step(frameTime, Air());
        const viewer::Picture picture = pictureOf(effects);
        for (const viewer::Streak& streak : picture.streaks)
            if (std::abs(streak.from.x()) < 0.49f && std::abs(streak.from.z()) < 0.49f) {
                ASSERT_GT(streak.from.y(), 2.04f);
                aboveRoof = true;
            }
        for (const viewer::WetPatch& patch : picture.patches) {
            const bool below = std::abs(patch.centre.x()) < 0.49f && std::abs(patch.centre.z()) < 0.49f;
            ASSERT_TRUE(!below || patch.centre.y() > 2.04f);
            onRoof = onRoof || below;
            inTheOpen = inTheOpen || !below;
        }
    }
    EXPECT_TRUE(aboveRoof);
    EXPECT_TRUE(onRoof);
    EXPECT_TRUE(inTheOpen);
}

TEST(WaterEffects, ARoofOverTheRegionKeepsAllOfItDry) {
    const auto world = worldWithGround();
    world->addBox({0, 5, 0}, {3, 0.05f, 3});
    WaterEffects effects(world->world());
    effects.rain(60, downwards, region(1, 3));
    for (int frame = 0; frame < 60; ++frame) effects.step(frameTime, Air());
    EXPECT_TRUE(pictureOf(effects).streaks.empty());
    EXPECT_EQ(effects.spots().size(), 0u);
}

TEST(WaterEffects, SheetsAndPoolsStopTheRain) {
    const auto world = worldWithGround();
    SceneCloth cloth(*world, sheetOf({-0.5, 1, -0.5}, {1, 0, 0}, {0, 0, 1}, 31), 1);
    WaterEffects effects(world->world());
    effects.setPools({{Eigen::Vector3d(0.6, 0, -1), Eigen::Vector3d(1, 0.5, 1)}});
    effects.rain(60, downwards, region(1, 3));
    bool above = false;
    for (int frame = 0; frame < 120; ++frame) {
        effects.step(frameTime, Air());
        for (const viewer::Streak& streak : pictureOf(effects).streaks) {
            const bool overSheet = std::abs(streak.from.x()) < 0.48f && std::abs(streak.from.z()) < 0.48f;
            ASSERT_TRUE(!overSheet || streak.from.y() > 0.95f);
            ASSERT_TRUE(streak.from.x() < 0.6f || streak.from.y() > 0.5f);
            above = above || overSheet;
        }
    }
    EXPECT_TRUE(above);
    EXPECT_FALSE(pictureOf(effects).patches.empty());
    for (const viewer::WetPatch& patch : pictureOf(effects).patches) EXPECT_LT(patch.centre.x(), 0.6f);
}

TEST(WaterEffects, ASprayStaysInItsConeAndWetsWhatItMeets) {
    const auto world = worldWithGround();
    btRigidBody& wall = world->addBox({0, 1, 1.05f}, {1, 1, 0.05f});
    WaterEffects effects(world->world());
    Nozzle nozzle;
    nozzle.position = {0, 1, 0};
    nozzle.halfAngle = 0.2;
    for (int frame = 0; frame < 60; ++frame) {
        effects.spray(nozzle);
        effects.step(frameTime, Air());
    }
    const viewer::Picture picture = pictureOf(effects);
    ASSERT_FALSE(picture.patches.empty());
    EXPECT_FALSE(picture.mist.empty());
    int onWall = 0;
    for (const viewer::WetPatch& patch : picture.patches) {
        if (std::abs(patch.centre.z() - 1) > 1e-3f) continue;
        ++onWall;
        EXPECT_LT(std::abs(patch.centre.x()), 1.05 * std::tan(0.2));
    }
    EXPECT_GT(onWall, 0);
    // All that has left the nozzle and is not in the air any more is on the wall, until there is too much of
    // it.
    EXPECT_LE(effects.spots().mass(), nozzle.rate * 1.0);
    EXPECT_EQ(wall.getWorldTransform().getOrigin().x(), 0);
}

TEST(WaterEffects, RefusesWhatCannotBe) {
    const auto world = worldWithGround();
    WaterEffects effects(world->world());
    EXPECT_THROW(effects.rain(-1, downwards, region(1, 2)), std::invalid_argument);
    EXPECT_THROW(effects.rain(10, {0, 1, 0}, region(1, 2)), std::invalid_argument);
    EXPECT_THROW(effects.rain(10, downwards, {}), std::invalid_argument);
    EXPECT_THROW(effects.step(-1, Air()), std::invalid_argument);
    EXPECT_THROW(effects.step(frameTime, Air(), -1), std::invalid_argument);
    Nozzle nozzle;
    nozzle.direction.setZero();
    EXPECT_THROW(effects.spray(nozzle), std::invalid_argument);
    nozzle = {};
    nozzle.speed = 0;
    EXPECT_THROW(effects.spray(nozzle), std::invalid_argument);
}

}  // namespace
}  // namespace drench::demo::water_effects_test
