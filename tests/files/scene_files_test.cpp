// Fabric files and exported runs as the program uses them.
#include <drench/files/fabric_file.h>
#include <gtest/gtest.h>

#include "description/scene_file.h"
#include "glb_reader.h"
#include "run/exporter.h"
#include "scenes/registry.h"
#include "stage/stage.h"
#include "temporary_folder.h"

namespace drench::demo::scene_files_test {
namespace {

using test::refusal;
using test::TemporaryFolder;

SceneDescription twoSheets() {
    SceneDescription scene;
    for (int i = 0; i < 2; ++i) {
        SheetDescription& sheet = scene.sheets.emplace_back();
        sheet.nodes = {5, 4};
        sheet.corner.z() = i;
        sheet.pins = {{0, 0}, {-1, 0}};
    }
    scene.duration = 0.2;
    return scene;
}

TEST(FabricOfAScene, FromAFileSurvivesTheSceneFile) {
    const TemporaryFolder folder;
    Fabric twill = fabrics::denim();
    twill.name = "twill, 11 oz";
    twill.thickness = {0.7e-3, Provenance::measured, "Doe 2001"};
    writeFabric(folder / "twill.json", twill);
    SceneDescription scene = twoSheets();
    scene.sheets[0].fabric = fabricDescription((folder / "twill.json").string());
    scene.sheets[1].fabric = fabricDescription("linen");
    scene.sheets[1].name = "other";
    const SceneDescription read = readScene(sceneText(scene));
    const Fabric again = read.sheets[0].fabric.fabric();
    EXPECT_EQ(again.name, twill.name);
    EXPECT_EQ(again.construction, Construction::twill);
    for (const FabricParameter& parameter : fabricParameters()) {
        EXPECT_EQ((again.*parameter.member).value, (twill.*parameter.member).value) << parameter.name;
        EXPECT_EQ((again.*parameter.member).source, (twill.*parameter.member).source) << parameter.name;
    }
    EXPECT_NE(sceneText(scene).find("\"fabric\": \"linen\""), std::string::npos);
    EXPECT_THROW(fabricDescription("tweed"), std::invalid_argument);
    EXPECT_THROW(fabricDescription((folder / "none.json").string()), std::runtime_error);
}

TEST(FabricOfAScene, UnitsAreThoseOfFabricFiles) {
    const SceneDescription scene =
        readScene(R"({"sheets": [{"fabric": {"like": "wool", "thickness": {"value": 2, "unit": "mm"}}}]})");
    EXPECT_EQ(scene.sheets[0].fabric.fabric().thickness.value, 0.002);
    EXPECT_NE(refusal<std::invalid_argument>([] {
                  readScene(R"({"sheets": [{"fabric": {"thickness": {"value": 2, "unit": "kg"}}}]})");
              }).find("sheets[0].fabric.thickness.unit is \"kg\""),
              std::string::npos);
}

TEST(Exporter, KeepsEveryNthFrameOfAllSheets) {
    const TemporaryFolder folder;
    SceneDescription description = twoSheets();
    description.sheets[1].name = "other";
    SceneOptions options;
    options.fabric.clear();
    const auto scene = makeScene(description, options);
    Exporter animation(folder / "run.glb", 3), tables(folder / "cloth.csv", 5);
    for (int frame = 0; frame < 12; ++frame) {
        scene->advance();
        animation.add(*scene);
        tables.add(*scene);
    }
    EXPECT_TRUE(animation.finish());
    EXPECT_TRUE(tables.finish());
    EXPECT_EQ(folder.files(), 3u);
    const test::GlbReader file(test::contentsOf(folder / "run.glb"));
    const auto& sampler = file.json()["animations"][0]["samplers"][0];
    const std::vector<float> times = file.floats(sampler["input"].get<int>());
    ASSERT_EQ(times.size(), 4u);
    EXPECT_NEAR(times[3], 9 * Scene::frameTime, 1e-6);
    const std::vector<float> positions = file.attribute(1, "POSITION", 3);
    const auto now = framesOf(*scene);
    ASSERT_EQ(now.size(), 2u);
    EXPECT_EQ(now[1].name, "other");
    for (std::size_t n = 0; n < now[1].positions.size(); ++n)
        EXPECT_NEAR(positions[3 * n + 1], now[1].positions[n].y(),
                    1e-6);  // the twelfth frame is the last that was kept
    EXPECT_NE(test::contentsOf(folder / "cloth.0002.csv").find("\n0.166666667,other,19,"), std::string::npos);
}

TEST(Exporter, SaysWhatItCannotWriteAndTakesNoMore) {
    const TemporaryFolder folder;
    SceneOptions options;
    options.fabric.clear();
    const auto scene = makeScene(twoSheets(), options);
    test::put(folder / "taken", "");
    Exporter exporter(folder / "taken" / "cloth.obj", 1);
    scene->advance();
    testing::internal::CaptureStderr();
    exporter.add(*scene);
    exporter.add(*scene);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("cloth.0001.obj"), std::string::npos) << said;
    EXPECT_EQ(said.find("cloth.0002.obj"), std::string::npos);
    EXPECT_FALSE(exporter.finish());
}

TEST(Exporter, SheetsOfANameGetNumbers) {
    SceneOptions options;
    options.fabric.clear();
    const auto scene = makeScene(twoSheets(), options);
    const auto frames = framesOf(*scene);
    EXPECT_EQ(frames[0].name, "sheet");
    EXPECT_EQ(frames[1].name, "sheet 2");
}

}  // namespace
}  // namespace drench::demo::scene_files_test
