// Scenes that are saved while they run.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "description/scene_file.h"
#include "scenes/registry.h"
#include "stage/scene.h"
#include "stage/stage.h"

namespace drench::demo::saved_scene_test {
namespace {

// Largest distance between the same nodes of two sheets, m.
double farthest(const SceneCloth& a, const SceneCloth& b) {
    double max = 0;
    for (int n = 0; n < a.body().m_nodes.size(); ++n)
        max = std::max(max, double((a.body().m_nodes[n].m_x - b.body().m_nodes[n].m_x).length()));
    return max;
}

SceneDescription wetSheetInTheWind() {
    return readScene(R"({
      "weather": {"windSpeed": 3, "gusts": 0.3, "humidity": 0.4},
      "sheets": [{"nodes": [17, 17], "pins": [[0, 0], [-1, 0]], "saturation": 1.3, "damping": 0.5}],
      "solids": [{"shape": "ground"}, {"name": "ball", "position": [0, 2, 0.2], "radius": 0.1, "mass": 1}]})");
}

TEST(SavedScene, HasEveryNodeWhereItIsWithItsWater) {
    Stage running(wetSheetInTheWind());
    for (int i = 0; i < 60; ++i) running.step(Scene::frameTime);
    Stage loaded(readScene(sceneText(running.describe())));
    const SceneCloth &before = *running.sheets()[0], &after = *loaded.sheets()[0];
    EXPECT_EQ(farthest(before, after), 0);
    for (std::size_t n = 0; n < before.wet().moisture().size(); ++n) {
        EXPECT_NEAR(after.wet().moisture().poreMass()[n], before.wet().moisture().poreMass()[n], 1e-12);
        EXPECT_NEAR(after.wet().moisture().filmMass()[n], before.wet().moisture().filmMass()[n], 1e-12);
    }
    EXPECT_NEAR(after.wet().waterMass(), before.wet().waterMass(), 1e-9);
    EXPECT_EQ(loaded.solid("ball").getWorldTransform().getOrigin(),
              running.solid("ball").getWorldTransform().getOrigin());
    EXPECT_EQ(loaded.time(), running.time());
}

TEST(SavedScene, ThatCouldNotBeLoadedIsRefusedAndLeavesTheFileThatIsThere) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "drench_saved_scene";
    const auto file = folder / "scene.json";
    SceneDescription scene = wetSheetInTheWind();
    saveScene(file, scene);
    const auto before = sceneText(loadScene(file));
    scene.solids[1].spin = {0, 1e5, 0};
    try {
        saveScene(file, scene);
        FAIL() << "saved a scene that cannot be loaded";
    } catch (const std::runtime_error& problem) {
        EXPECT_NE(std::string(problem.what()).find("solids[1].spin"), std::string::npos) << problem.what();
    }
    EXPECT_EQ(sceneText(loadScene(file)), before);
    std::filesystem::remove_all(folder);
}

// How far a scene that was saved after a second and loaded is from the one that ran on, after another half, m.
double apart(const SceneDescription& scene) {
    Stage running(scene);
    for (int i = 0; i < 60; ++i) running.step(Scene::frameTime);
    Stage loaded(readScene(sceneText(running.describe())));
    for (int i = 0; i < 30; ++i) {
        running.step(Scene::frameTime);
        loaded.step(Scene::frameTime);
    }
    const SceneCloth &before = *running.sheets()[0], &after = *loaded.sheets()[0];
    EXPECT_NEAR(after.wet().waterMass(), before.wet().waterMass(), 1e-3 * before.wet().waterMass());
    return farthest(before, after);
}

TEST(SavedScene, GoesOnClosely) {
    SceneDescription scene = wetSheetInTheWind();
    scene.weather.windSpeed = 0;
    EXPECT_LT(apart(scene), 2e-5) << "in still air";
    scene.weather.windSpeed = 3;
    scene.weather.gusts = 0;
    EXPECT_LT(apart(scene), 0.03) << "in wind, whose forecast of the sheet's motion begins anew";
}

TEST(SavedScene, CanBeMadeOfEveryBuiltInSceneOfRectangles) {
    int described = 0;
    for (const SceneEntry& entry : scenes()) {
        SceneOptions options;
        options.fabric = entry.fabric;
        options.resolution = 12;
        const auto scene = makeScene(entry.name, options);
        for (int i = 0; i < 5; ++i) scene->advance();
        for (Stage* stage : scene->stages()) {
            if (entry.name == "drape-meter") {
                EXPECT_THROW(stage->describe(), std::runtime_error);
                continue;
            }
            const std::string text = sceneText(stage->describe());
            EXPECT_EQ(sceneText(readScene(text)), text) << entry.name;
            Stage again(readScene(text));
            again.step(Scene::frameTime);
            EXPECT_TRUE(again.sheets().front()->wet().health().finite) << entry.name;
            ++described;
        }
    }
    EXPECT_GE(described, int(scenes().size()) - 1);
}

TEST(SavedScene, KeepsWhatASoakHasStillToGive) {
    Stage running(readScene(R"({
      "weather": {"vapourExchange": 0},
      "sheets": [{"nodes": [9, 9]}],
      "sources": [{"kind": "soak", "massPerArea": 0.1, "duration": 1, "radius": 3}]})"));
    for (int i = 0; i < 30; ++i) running.step(Scene::frameTime);
    Stage loaded(readScene(sceneText(running.describe())));
    for (int i = 0; i < 60; ++i) loaded.step(Scene::frameTime);
    EXPECT_NEAR(loaded.sheets()[0]->wet().ledger().supplied, 0.1, 1e-6);
    EXPECT_TRUE(loaded.describe().sources.empty());
}

}  // namespace
}  // namespace drench::demo::saved_scene_test
