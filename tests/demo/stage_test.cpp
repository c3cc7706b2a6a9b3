// Stages: weather, sources and solids do what their description says.
#include "stage/stage.h"

#include <gtest/gtest.h>

#include <string>

#include "description/scene_file.h"
#include "stage/scene.h"

namespace drench::demo::stage_test {
namespace {

// A level sheet of 1 m2, sealed from vapour, held all round.
SceneDescription levelSheet(const std::string& more = "") {
    return readScene(R"({"weather": {"vapourExchange": 0}, "sheets": [{"nodes": [11, 11],
        "corner": [-0.5, 1, -0.5], "warp": [1, 0, 0], "weft": [0, 0, 1],
        "pins": [[0, "all"], [-1, "all"], ["all", 0], ["all", -1]]}])" +
                     more + "}");
}

void run(Stage& stage, double seconds) {
    for (double time = 0; time < seconds - 1e-9; time += Scene::frameTime) stage.step(Scene::frameTime);
}

double supplied(Stage& stage) {
    return stage.sheets()[0]->wet().ledger().supplied;
}

TEST(Stage, ItRainsWhileTheWeatherSaysSo) {
    Stage stage(levelSheet());
    run(stage, 0.5);
    EXPECT_EQ(supplied(stage), 0);
    stage.weather().rain = 360;  // 0.1 kg/m2 a second
    run(stage, 1);
    EXPECT_NEAR(supplied(stage), 0.1, 0.01);
    stage.weather().rain = 0;
    const double after = supplied(stage);
    run(stage, 0.5);
    EXPECT_EQ(supplied(stage), after);
}

TEST(Stage, TheWindBlowsAsTheWeatherSays) {
    Stage stage(levelSheet());
    stage.weather().windSpeed = 4;
    stage.weather().windDirection = {3, 0, 4};
    run(stage, 0.1);
    const Air& air = stage.sheets()[0]->wet().air();
    EXPECT_TRUE(air.wind.isApprox(Eigen::Vector3d(2.4, 0, 3.2)));
    EXPECT_EQ(air.field, nullptr);
    stage.weather().gusts = 0.2;
    run(stage, 0.1);
    ASSERT_NE(air.field, nullptr);
    EXPECT_TRUE(air.wind.isZero());
    const auto gusts = air.field;
    run(stage, 0.1);
    EXPECT_EQ(air.field, gusts) << "gusts are made anew though nothing has changed";
    stage.weather().windSpeed = 5;
    run(stage, 0.1);
    EXPECT_NE(air.field, gusts);
}

TEST(Stage, ASourceComesAndGoesByTheClock) {
    Stage stage(levelSheet(R"(, "sources": [{"kind": "brush", "centre": [0, 1, 0], "radius": 1, "rate": 0.1,
        "from": 0.5, "until": 1}])"));
    run(stage, 0.5);
    EXPECT_EQ(supplied(stage), 0);
    run(stage, 0.5);
    const double after = supplied(stage);
    EXPECT_GT(after, 0);
    run(stage, 0.5);
    EXPECT_EQ(supplied(stage), after);
}

TEST(Stage, ASourceMayBeChangedWhileItWorks) {
    Stage stage(levelSheet(R"(, "sources": [{"name": "hose", "origin": [0, 2, 0], "halfAngle": 20}])"));
    run(stage, 0.2);
    EXPECT_EQ(supplied(stage), 0);
    std::get<SprayDescription>(stage.source("hose").water).rate = 0.05;
    run(stage, 1);
    EXPECT_NEAR(supplied(stage), 0.05, 0.01);
}

TEST(Stage, ASoakWetsItsCircleOnly) {
    Stage stage(levelSheet(R"(, "sources": [{"kind": "soak", "centre": [0.2, 0.3], "radius": 0.16,
        "massPerArea": 0.1}])"));
    run(stage, 0.1);
    const SceneCloth& sheet = *stage.sheets()[0];
    for (int n = 0; n < sheet.body().m_nodes.size(); ++n) {
        const double away = (sheet.flatPosition(n) - Eigen::Vector2d(0.2, 0.3)).norm();
        const double content = sheet.wet().moistureContent(n);
        EXPECT_TRUE(away > 0.15 || content > 0.1) << n << " holds " << content;
        EXPECT_TRUE(away < 0.45 || content < 1e-3) << n << " holds " << content;
    }
}

TEST(Stage, WithoutWaterNothingGetsWet) {
    SceneDescription scene =
        levelSheet(R"(, "sources": [{"rate": 1}, {"name": "pool", "kind": "pool", "level": 2}])");
    scene.sheets[0].saturation = 1;
    scene.weather.rain = 100;
    scene.weather.vapourExchange = 1;
    scene.water = false;
    Stage stage(scene);
    run(stage, 1);
    EXPECT_EQ(supplied(stage), 0);
    EXPECT_FALSE(stage.hasWater());
}

TEST(Stage, WaterRunsAsFastAsItIsSet) {
    SceneDescription scene = levelSheet();
    scene.weather.vapourExchange = 1;
    scene.sheets[0].saturation = 0.5;
    Stage slow(scene), fast(scene);
    fast.setWaterSpeed(100);
    run(slow, 1);
    run(fast, 1);
    EXPECT_NEAR(fast.sheets()[0]->wet().ledger().evaporated / slow.sheets()[0]->wet().ledger().evaporated,
                100, 2);
    EXPECT_EQ(fast.describe().sheets[0].waterSpeed, 100);
    EXPECT_THROW(fast.setWaterSpeed(-1), std::invalid_argument);
}

TEST(Stage, SolidsHoldClothAndOnesToLookAtDoNot) {
    for (const bool touches : {true, false}) {
        SceneDescription scene = levelSheet();
        scene.sheets[0].pins.clear();
        SolidDescription pole;
        pole.shape = SolidDescription::Shape::capsule;
        pole.radius = 0.1;
        pole.length = 2;
        pole.position = {0, 0.7, 0};
        pole.turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitX());
        pole.touches = touches;
        scene.solids = {pole};
        Stage stage(scene);
        run(stage, 1);
        EXPECT_EQ(stage.sheets()[0]->highest() > 0.75, touches);
        viewer::Picture picture;
        stage.show(picture, View::beauty);
        EXPECT_EQ(picture.rods.size(), 1u);
    }
}

TEST(Stage, NamesAreFoundOrListed) {
    Stage stage(levelSheet(R"(, "solids": [{"name": "ball"}])"));
    EXPECT_EQ(&stage.sheet("sheet"), stage.sheets()[0]);
    EXPECT_NO_THROW(stage.solid("ball"));
    try {
        stage.sheet("shirt");
        ADD_FAILURE() << "there is a shirt";
    } catch (const std::invalid_argument& problem) {
        EXPECT_NE(std::string(problem.what()).find("'sheet'"), std::string::npos);
    }
    EXPECT_THROW(stage.solid("box"), std::invalid_argument);
    EXPECT_THROW(stage.source("tap"), std::invalid_argument);
}

}  // namespace
}  // namespace drench::demo::stage_test
