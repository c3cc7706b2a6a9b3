// Scene files: what they may say, and what they refuse.
#include "description/scene_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "files/json_text.h"
#include "scenes/described_scene.h"
#include "scenes/scene_texts.h"
#include "stage/stage.h"

namespace drench::demo::scene_file_test {
namespace {

namespace fs = std::filesystem;

// What the text is refused with; empty if it is taken.
std::string refusal(const std::string& text) {
    try {
        readScene(text);
    } catch (const std::invalid_argument& problem) {
        return problem.what();
    }
    return "";
}

// A scene with one sheet, with more keys in the sheet and in the whole.
std::string withSheet(const std::string& inSheet, const std::string& inScene = "") {
    return "{" + inScene + (inScene.empty() ? "" : ",") + "\"sheets\": [{" + inSheet + "}]}";
}

std::string contentsOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// A folder that is there during a test.
class SceneFiles : public testing::Test {
  protected:
    SceneFiles()
        : folder_(fs::temp_directory_path() / ("scene-files-" + std::to_string(std::random_device()()))) {
        fs::create_directories(folder_);
    }
    ~SceneFiles() override { fs::remove_all(folder_); }

    fs::path folder_;
};

// What loading a file is refused with; empty if it is taken.
std::string loadRefusal(const fs::path& path) {
    try {
        loadScene(path);
    } catch (const std::runtime_error& problem) {
        return problem.what();
    }
    return "";
}

// Everything that a scene may have, none of it as by default.
SceneDescription fullScene() {
    SceneDescription scene;
    scene.name = "full";
    scene.text = "ünïcode and \"quotes\"";
    scene.duration = 3.25;
    scene.time = 1.5;
    scene.seed = 7;
    scene.solver = {WorldKind::softRigid, SolverKind::stock, 12, 9, 3};
    scene.weather = {25, 0.5, 3, {1, 0, 1}, 0.2, 4, 2, 30, 0.5};
    SheetDescription sheet;
    sheet.name = "one";
    sheet.fabric = {"denim", "stiff denim", {{"bending", 4e-4}, {"plateFrictionDry", 0.5}}};
    sheet.nodes = {5, 4};
    sheet.pins = {{0, 0}, {-1, std::nullopt}};
    sheet.slack = 0.05;
    sheet.waves = 2;
    sheet.saturation = 0.5;
    sheet.presoak = 0.01;
    sheet.waterSpeed = 60;
    sheet.damping = 1;
    scene.sheets.push_back(sheet);
    sheet.name = "two";
    sheet.corner = {2, 1, 0};
    sheet.state = SheetState{std::vector<Eigen::Vector3d>(20, {0.1, 0.2, 0.3}),
                             std::vector<Eigen::Vector3d>(20, {1, 2, 3}), std::vector<double>(20, 1e-3),
                             std::vector<double>(20, 1e-5)};
    scene.sheets.push_back(sheet);
    SolidDescription solid;
    solid.name = "box";
    solid.shape = SolidDescription::Shape::box;
    solid.turn = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX());
    solid.mass = 2;
    solid.velocity = {0, 0, 1};
    solid.spin = {1, 0, 0};
    solid.surface = SurfaceKind::skin;
    solid.colour = {0.1, 0.2, 0.3};
    scene.solids.push_back(solid);
    solid.name = "rod";
    solid.shape = SolidDescription::Shape::capsule;
    solid.touches = false;
    scene.solids.push_back(solid);
    for (const auto& water : std::vector<decltype(SourceDescription::water)>{
             SprayDescription(), PoolDescription(), SoakDescription(), BrushDescription()}) {
        SourceDescription source;
        source.name = "source " + std::to_string(scene.sources.size());
        source.sheets = {"two"};
        source.from = 1;
        source.until = 2;
        source.water = water;
        if (auto* pool = std::get_if<PoolDescription>(&source.water)) pool->level = 0.2;
        scene.sources.push_back(source);
    }
    return scene;
}

TEST(SceneFile, SaysTheSameAfterBeingRead) {
    const std::string text = sceneText(fullScene());
    const SceneDescription read = readScene(text);
    EXPECT_EQ(sceneText(read), text);
    EXPECT_EQ(read.sheets.at(1).state->positions.at(19), Eigen::Vector3d(0.1, 0.2, 0.3));
    EXPECT_EQ(read.sheets.at(0).fabric.changes.size(), 2u);
    EXPECT_FALSE(read.sheets.at(0).pins.at(1).weft.has_value());
    EXPECT_EQ(read.solver.solver, SolverKind::stock);
    EXPECT_EQ(read.sources.at(2).water.index(), 2u);
}

TEST(SceneFile, EmptyObjectIsASceneOfDefaults) {
    const SceneDescription read = readScene("{}");
    EXPECT_EQ(sceneText(read), sceneText(SceneDescription()));
}

TEST(SceneFile, RefusesByPathWithWhatMayBeGiven) {
    struct Case {
        std::string text;
        std::vector<std::string> says;
    };
    const std::string state5x4 = R"("nodes":[5,4],"state":)";
    const std::vector<Case> cases = {
        {"[]", {"the file is a list of 0", "object"}},
        {R"({"wether": {}})", {"wether is no key", "weather"}},
        {R"({"weather": {"wind": 3}})", {"weather.wind is no key", "windSpeed"}},
        {R"({"weather": 3})", {"weather is 3", "object"}},
        {R"({"weather": {"humidity": 1.5}})", {"weather.humidity is 1.5", "0 to 0.999"}},
        {R"({"weather": {"humidity": "damp"}})", {"weather.humidity is \"damp\"", "number"}},
        {R"({"weather": {"windDirection": [0, 0, 0]}})", {"weather.windDirection is too short"}},
        {R"({"weather": {"windDirection": [0, 0]}})", {"weather.windDirection is a list of 2", "3 numbers"}},
        {R"({"duration": -1})", {"duration is -1", "0.02"}},
        {R"({"seed": 1.5})", {"seed is 1.5", "whole number"}},
        {R"({"water": 1})", {"water is 1", "true or false"}},
        {R"({"name": "../../etc/passwd"})", {"name is \"../../etc/passwd\"", "letters"}},
        {R"({"name": ""})", {"name is \"\"", "letters"}},
        {R"({"text": 5})", {"text is 5"}},
        {R"({"solver": {"world": "moon"}})", {"solver.world is \"moon\"", "soft-rigid", "deformable"}},
        {R"({"camera": {"pitch": 90}})", {"camera.pitch is 90", "-89"}},
        {R"({"sheets": {}})", {"sheets is an object", "list"}},
        {R"({"sheets": [3]})", {"sheets[0] is 3", "object"}},
        {withSheet(R"("fabric": "tweed")"), {"sheets[0].fabric is \"tweed\"", "cotton"}},
        {withSheet(R"("fabric": {"stretchWarp": -3})"), {"sheets[0].fabric.stretchWarp is -3", "1"}},
        {withSheet(R"("fabric": {"strechWarp": 3})"), {"sheets[0].fabric.strechWarp is no key"}},
        {withSheet(R"("fabric": {"shear": 1e6})"), {"sheets[0].fabric does not hold together"}},
        {withSheet(R"("nodes": [1, 20])"), {"sheets[0].nodes[0] is 1", "2"}},
        {withSheet(R"("nodes": [2.5, 20])"), {"sheets[0].nodes", "whole"}},
        {withSheet(R"("nodes": [9999, 9999])"), {"sheets[0].nodes", "250000"}},
        {withSheet(R"("pins": [[32, 0]])"), {"sheets[0].pins[0][0] is 32", "-32 to 31"}},
        {withSheet(R"("pins": [[0, 0], [0]])"), {"sheets[0].pins[1] is a list of 1", "pair"}},
        {withSheet(R"("pins": "corners")"), {"sheets[0].pins is \"corners\"", "list"}},
        {withSheet(R"("warp": [0, 0, 0])"), {"sheets[0].warp is too short"}},
        {withSheet(R"("warp": [1, 0, 0], "weft": [2, 0, 0])"), {"sheets[0].weft runs along the warp"}},
        {withSheet(R"("presoak": 1e999)"), {"1e999"}},
        {withSheet(state5x4 + "{}"), {"sheets[0].state.positions has numbers for 0 nodes", "20"}},
        {withSheet(state5x4 + R"({"positions":[1,2]})"),
         {"sheets[0].state.positions is a list of 2", "three"}},
        {R"({"sheets": [{}, {}]})", {"sheets[1].name is \"sheet\", which another has"}},
        {R"({"sheets": [{"nodes": [400, 400]}, {"name": "b", "nodes": [400, 400]}]})",
         {"sheets have", "250000"}},
        {R"({"solids": [{"shape": "cone"}]})", {"solids[0].shape is \"cone\"", "capsule"}},
        {R"({"solids": [{"shape": "ball", "radius": 0}]})", {"solids[0].radius is 0"}},
        {R"({"solids": [{"shape": "ball", "mass": 1e-42}]})", {"solids[0].mass is", "1e-6"}},
        {R"({"solids": [{"shape": "ball", "halfExtents": [1, 1, 1]}]})", {"solids[0].halfExtents is no key"}},
        {R"({"solids": [{"shape": "capsule", "from": [0, 0, 0], "to": [0, 0, 0]}]})",
         {"solids[0].to is where"}},
        {R"({"solids": [{"colour": [2, 0, 0]}]})", {"solids[0].colour[0] is 2"}},
        {withSheet("", R"("sources": [{"sheets": ["shirt"]}])"), {"sources[0].sheets names \"shirt\""}},
        {R"({"sources": [{"kind": "tap"}]})", {"sources[0].kind is \"tap\"", "spray"}},
        {R"({"sources": [{"kind": "pool", "level": -1}]})", {"sources[0].bottom is 0,", "below", "lower"}},
        {R"({"sources": [{"rate": 1}, {"rate": 2}]})", {"sources[1].name", "another"}},
    };
    for (const Case& each : cases) {
        const std::string why = refusal(each.text);
        EXPECT_FALSE(why.empty()) << each.text << " is taken";
        for (const std::string& part : each.says)
            EXPECT_NE(why.find(part), std::string::npos)
                << each.text << "\n  says: " << why << "\n  not: " << part;
    }
}

TEST(SceneFile, NamesLineAndColumnOfBrokenSyntax) {
    EXPECT_NE(refusal("{\n  \"name\": \"a\",\n  \"seed\": ,\n}").find("line 3, column 11"), std::string::npos)
        << refusal("{\n  \"name\": \"a\",\n  \"seed\": ,\n}");
    for (const std::string& broken : std::vector<std::string>{
             "", "{", "{\"name\": \"a", "{\"a\": NaN}", "{\"a\": Infinity}", "{'a': 1}", "{\"a\": 1} x",
             "{\"a\": 01}", "// comment\n{}", std::string("\xff\xfe{\0}", 5)})
        EXPECT_NE(refusal(broken).find("line 1, column "), std::string::npos)
            << broken << ": " << refusal(broken);
    EXPECT_NE(refusal(std::string("{\"a\": \0}", 8)).find("line 1"), std::string::npos);
}

TEST(SceneFile, RefusesTextThatIsNotUtf8) {
    EXPECT_NE(refusal("{\"text\": \"\xc3\x28\"}").find("UTF-8"), std::string::npos);
}

TEST(SceneFile, RefusesAKeyThatIsThereTwice) {
    EXPECT_NE(refusal(R"({"weather": {"rain": 1, "rain": 2}})").find("weather.rain is there twice"),
              std::string::npos);
    EXPECT_NE(
        refusal(R"({"sheets": [{}, {"name": "a", "name": "b"}]})").find("sheets[1].name is there twice"),
        std::string::npos);
}

TEST(SceneFile, RefusesBombs) {
    EXPECT_NE(refusal(std::string(1'000'000, '[')).find("deep"), std::string::npos);
    std::string objects;
    for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
    EXPECT_NE(refusal(objects).find("deep"), std::string::npos);
    std::string solids = "{\"solids\": [{}";
    for (int i = 0; i < 1000; ++i) solids += ",{}";
    EXPECT_NE(refusal(solids + "]}").find("solids is a list of 1001"), std::string::npos);
    files::JsonLimits tight;
    tight.values = 1000;
    std::string many = "[0";
    for (int i = 0; i < 2000; ++i) many += ",0";
    EXPECT_THROW(files::parseJson(many + "]", tight), std::invalid_argument);
    tight = {};
    tight.bytes = 100;
    EXPECT_THROW(files::parseJson(std::string(101, ' '), tight), std::invalid_argument);
}

TEST(SceneFile, MessagesAreShortAndPlain) {
    for (const std::string& hostile :
         std::vector<std::string>{"{\"\\u001b[2J" + std::string(100'000, 'k') + "\": 1}",
                                  "{\"name\": \"" + std::string(100'000, 'n') + "\\u001b\"}",
                                  "{\"name\": \"" + std::string(100'000, 'n')}) {
        const std::string why = refusal(hostile);
        EXPECT_FALSE(why.empty());
        EXPECT_LT(why.size(), 500u);
        EXPECT_EQ(why.find('\x1b'), std::string::npos);
    }
}

TEST(SceneFile, SurvivesAnyChangeOfAByte) {
    const std::string text = sceneText(fullScene());
    std::mt19937 random(1);
    std::uniform_int_distribution<std::size_t> position(0, text.size() - 1);
    std::uniform_int_distribution<int> byte(0, 255);
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string changed = text;
        for (int k = 0; k <= i % 3; ++k) changed[position(random)] = char(byte(random));
        if (i % 5 == 0) changed.resize(position(random));
        refused += refusal(changed).empty() ? 0 : 1;
    }
    EXPECT_GT(refused, 1000);
}

TEST_F(SceneFiles, RefusesWhatIsNoFile) {
    EXPECT_NE(loadRefusal(folder_ / "missing.json").find("missing.json: there is no such file"),
              std::string::npos);
    EXPECT_NE(loadRefusal(folder_).find("it is no file"), std::string::npos);
    EXPECT_NE(loadRefusal("/dev/zero").find("it is no file"), std::string::npos);
    std::ofstream(folder_ / "empty.json").close();
    EXPECT_NE(loadRefusal(folder_ / "empty.json").find("line 1, column 1"), std::string::npos);
    std::ofstream(folder_ / "huge.json") << "{}";
    fs::resize_file(folder_ / "huge.json", std::uintmax_t(1) << 36);  // without taking the room
    EXPECT_NE(loadRefusal(folder_ / "huge.json").find("more than 64 MB"), std::string::npos);
}

TEST_F(SceneFiles, SavingLeavesNothingHalfMade) {
    const fs::path path = folder_ / "new" / "scene.json";
    saveScene(path, fullScene());
    EXPECT_EQ(sceneText(loadScene(path)), sceneText(fullScene()));
    EXPECT_EQ(std::distance(fs::directory_iterator(path.parent_path()), {}), 1);
    fs::create_directories(folder_ / "folder.json");
    EXPECT_THROW(saveScene(folder_ / "folder.json", fullScene()), std::runtime_error);
    EXPECT_THROW(saveScene("/proc/no/such.json", fullScene()), std::runtime_error);
}

// The blocks of JSON in a page.
std::vector<std::string> examplesIn(const std::string& page) {
    std::vector<std::string> examples;
    const std::string opening = "```json\n";
    for (std::size_t at = page.find(opening); at != std::string::npos; at = page.find(opening, at)) {
        const std::size_t from = at + opening.size();
        at = page.find("```", from);
        examples.push_back(page.substr(from, at - from));
    }
    return examples;
}

TEST(SceneFile, ExamplesOfTheDocumentationRun) {
    const auto examples = examplesIn(contentsOf(fs::path(DRENCH_SOURCE_DIR) / "docs/scene-files.md"));
    EXPECT_GE(examples.size(), 2u);
    for (const std::string& example : examples) {
        Stage stage(readScene(example));
        for (int i = 0; i < 10; ++i) stage.step(Scene::frameTime);
        for (const SceneCloth* sheet : stage.sheets()) EXPECT_TRUE(sheet->wet().health().finite) << example;
    }
}

TEST(SceneFile, TheDocumentationNamesEveryKey) {
    const std::string page = contentsOf(fs::path(DRENCH_SOURCE_DIR) / "docs/scene-files.md");
    std::istringstream lines(sceneText(fullScene()));
    for (std::string line; std::getline(lines, line);) {
        const std::size_t from = line.find('"'), to = line.find("\": ");
        if (to == std::string::npos) continue;
        const std::string key = line.substr(from + 1, to - from - 1);
        const bool isOfFabric = key == "bending" || key == "plateFrictionDry";
        EXPECT_TRUE(isOfFabric || page.find('`' + key + '`') != std::string::npos) << key;
    }
}

TEST(SceneFile, ExampleScenesRunAndPassTheirCheck) {
    int found = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(DRENCH_SOURCE_DIR) / "demos/scene_files")) {
        SceneOptions options;
        options.fabric.clear();
        options.seconds = 2;
        DescribedScene scene(loadScene(entry.path()), options);
        while (!scene.finished()) scene.advance();
        EXPECT_EQ(scene.failures(), std::vector<std::string>()) << entry.path();
        EXPECT_FALSE(scene.picture(View::beauty).sheets.empty());
        ++found;
    }
    EXPECT_GE(found, 2);
}

TEST(SceneFile, OptionsGiveADescriptionAnotherFabricAndResolution) {
    SceneDescription scene = readScene(withSheet(R"("nodes": [21, 11], "saturation": 0.5)"));
    SceneOptions options;
    options.fabric = "silk";
    options.resolution = 41;
    options.seconds = 2.5;
    const SceneDescription made = fitted(scene, options);
    EXPECT_EQ(made.sheets[0].fabric.like, "silk");
    EXPECT_EQ(made.sheets[0].nodes, (std::array<int, 2>{41, 21}));
    EXPECT_EQ(made.duration, 2.5);
    scene = fullScene();
    EXPECT_THROW(fitted(scene, options), std::invalid_argument);
}

}  // namespace
}  // namespace drench::demo::scene_file_test
