// Fabric files: what is written comes back, other programs can check it, and what is off is named.
#include <drench/files/fabric_file.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "temporary_folder.h"

namespace drench::fabric_file_test {
namespace {

using test::refusal;
using test::TemporaryFolder;

void expectSame(const Fabric& a, const Fabric& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.construction, b.construction);
    for (const FabricParameter& parameter : fabricParameters()) {
        const Quantity &x = a.*parameter.member, &y = b.*parameter.member;
        EXPECT_EQ(x.value, y.value) << parameter.name;
        EXPECT_EQ(x.provenance, y.provenance) << parameter.name;
        EXPECT_EQ(x.source, y.source) << parameter.name;
    }
}

// Why text is refused; empty if it is not.
std::string whyNot(const std::string& text) {
    return refusal<std::invalid_argument>([&] { fabricFromText(text); });
}

void expectRefused(const std::string& text, const std::vector<std::string>& words) {
    const std::string why = whyNot(text);
    for (const std::string& word : words) EXPECT_NE(why.find(word), std::string::npos) << text << "\n" << why;
}

TEST(FabricFile, EveryPresetComesBackToTheLastBit) {
    const TemporaryFolder folder;
    for (const std::string& name : fabrics::names()) {
        const Fabric fabric = fabrics::byName(name);
        expectSame(fabricFromText(fabricText(fabric)), fabric);
        writeFabric(folder / "a" / (name + ".json"), fabric);
        expectSame(readFabric(folder / "a" / (name + ".json")), fabric);
    }
}

TEST(FabricFile, UnevenNumbersAndTextsComeBack) {
    Fabric fabric = fabrics::denim();
    fabric.name = "\"Köper\" \\ 11 oz,\n unwashed";
    fabric.thickness = {0.1 + 0.2e-3 / 3 - 0.0991, Provenance::measured, "own, 2026"};
    fabric.bending = std::nextafter(1e-5, 1);
    fabric.wettingTime = {1.0 / 3, Provenance::given, "guessed"};
    expectSame(fabricFromText(fabricText(fabric)), fabric);
}

TEST(FabricFile, SaysOnlyWhatIsOther) {
    const Fabric fabric = fabricFromText(
        R"({"$schema": "fabric.schema.json", "like": "linen", "name": "towel", "construction": "twill",
            "wettingTime": 1.5, "thickness": {"value": 0.5, "unit": "mm", "provenance": "measured", "source": "Doe 2001"}})");
    EXPECT_EQ(fabric.name, "towel");
    EXPECT_EQ(fabric.construction, Construction::twill);
    EXPECT_EQ(fabric.wettingTime.value, 1.5);
    EXPECT_EQ(fabric.wettingTime.provenance, Provenance::given);
    EXPECT_EQ(fabric.thickness.value, 0.0005);
    EXPECT_EQ(fabric.thickness.provenance, Provenance::measured);
    EXPECT_EQ(fabric.thickness.source, "Doe 2001");
    EXPECT_EQ(fabric.arealDensity.value, fabrics::linen().arealDensity.value);
    EXPECT_EQ(fabricFromText(R"({"like": "wool"})").name, fabrics::wool().name);
}

TEST(FabricFile, UnitsOfTextilesBecomeSi) {
    const auto read = [](const std::string& key, const std::string& value, const std::string& unit) {
        const Fabric fabric = fabricFromText(R"({"like": "cotton", ")" + key + R"(": {"value": )" + value +
                                             R"(, "unit": ")" + unit + "\"}}");
        for (const FabricParameter& parameter : fabricParameters())
            if (parameter.name == key) return (fabric.*parameter.member).value;
        return 0.0;
    };
    EXPECT_EQ(read("arealDensity", "102", "g/m2"), 0.102);
    EXPECT_NEAR(read("arealDensity", "4", "oz/yd2"), 0.1356, 1e-4);  // 33.9057 g/m2 each
    EXPECT_EQ(read("thickness", "250", "um"), 250e-6);
    EXPECT_EQ(read("fibreDensity", "1.52", "g/cm3"), 1520);
    EXPECT_EQ(read("regain", "7.5", "%"), 0.075);
    EXPECT_EQ(read("wettingTime", "2", "min"), 120);
    EXPECT_NEAR(read("contactAngle", "0.5", "rad"), 28.6479, 1e-4);
    EXPECT_NEAR(read("bending", "0.1", "gf cm2/cm"), 9.80665e-6, 1e-15);  // the units of the KES tester
    EXPECT_NEAR(read("bendingFriction", "0.05", "gf cm/cm"), 4.903325e-4, 1e-14);
    EXPECT_NEAR(read("stretchWarp", "2000", "gf/cm"), 1961.33, 1e-9);
    EXPECT_EQ(read("airPermeabilityDry", "120", "mm/s at 100 Pa"), 0.12);
    EXPECT_EQ(read("permeabilityWarp", "15", "um2"), 15e-12);
}

TEST(FabricFile, NamesTheKeyThatIsOff) {
    expectRefused(R"({"like": "cotton", "thicknes": 0.0003})",
                  {"thicknes is no key", "did you mean thickness?"});
    expectRefused(R"({"like": "cotton", "thickness": {"value": 1, "units": "mm"}})",
                  {"thickness.units is no key", "did you mean unit?"});
    expectRefused(R"({"like": "cotton", "thickness": {"value": 1, "unit": "g/m2"}})",
                  {"thickness.unit is \"g/m2\"", "\"m\", \"cm\", \"mm\", \"um\""});
    expectRefused(R"({"like": "cotton", "arealDensity": {"value": 100, "unit": "g/m"}})",
                  {"did you mean \"g/m2\"?"});
    expectRefused(R"({"like": "cotton", "thickness": {"unit": "mm"}})",
                  {"thickness.value is missing", "0.02 to 20 mm"});
    expectRefused(R"({"like": "cotton", "thickness": {"value": 21, "unit": "mm"}})",
                  {"thickness.value is 21 mm", "0.02 to 20 mm"});
    expectRefused(R"({"like": "cotton", "thickness": 3})", {"thickness is 3", "2e-5 to 0.02"});
    expectRefused(R"({"like": "cotton", "thickness": "thin"})", {"thickness is \"thin\"", "give a number"});
    expectRefused(R"({"like": "cotton", "thickness": null})", {"thickness is null"});
    expectRefused(R"({"like": "cotton", "thickness": NaN})", {"line 1, column 33"});
    expectRefused(R"({"like": "cotton", "thickness": 1e999})", {"number overflow"});
    expectRefused(R"({"like": "cotton", "like": "wool"})", {"like is there twice"});
    expectRefused(R"({"like": "cottn"})", {"like is \"cottn\"", "jersey"});
    expectRefused(R"({"like": "cotton", "construction": "felt"})", {"construction is \"felt\"", "\"twill\""});
    expectRefused(R"({"like": "cotton", "shear": {"value": 50, "provenance": "heard"}})",
                  {"shear.provenance"});
    expectRefused(R"({"like": "cotton", "shear": {"value": 50, "provenance": "measured"}})",
                  {"shear.source is missing"});
    expectRefused(R"({"name": "thin", "thickness": 0.0003})", {"arealDensity is missing", "kg/m2", "like"});
    expectRefused(R"({"like": "cotton", "name": ""})", {"no name"});
    expectRefused(R"({"like": "cotton", "shear": 5000})", {"shear is 5000", "smaller than stretchWarp"});
    expectRefused("[]", {"the file is a list"});
    expectRefused("", {"line 1"});
    expectRefused(R"({"like": "cotton"} {})", {"line 1, column 20"});
    expectRefused(R"({"like": [[[[[[[[[[]]]]]]]]]]})", {"8 deep"});
    expectRefused(std::string(2u << 20, ' '), {"1 MB"});
}

TEST(FabricFile, FilesOfVersion02HaveNoParametersOfLayers) {
    nlohmann::json json = nlohmann::json::parse(fabricText(fabrics::denim()));
    for (const char* const parameter : {"permeabilityThrough", "pressedThicknessRatio"})
        json.erase(parameter);
    const Fabric read = fabricFromText(json.dump()), cotton;
    EXPECT_EQ(read.permeabilityThrough, cotton.permeabilityThrough);
    EXPECT_EQ(read.pressedThicknessRatio, cotton.pressedThicknessRatio);
    EXPECT_EQ(read.pressedThicknessRatio.provenance, Provenance::assumed);
}

TEST(FabricFile, WhatNoLawReadsMayBeLeftOut) {
    Fabric fabric = fabrics::wool();
    fabric.contactAngle = {93, Provenance::measured, "own, 2026"};
    expectSame(fabricFromText(fabricText(fabric)), fabric);
    nlohmann::json json = nlohmann::json::parse(fabricText(fabric));
    json.erase("contactAngle");
    const Fabric read = fabricFromText(json.dump());
    EXPECT_EQ(read.contactAngle.provenance, Provenance::assumed);
    fabric.contactAngle = read.contactAngle;
    expectSame(read, fabric);
    json.erase("entryPressure");
    expectRefused(json.dump(), {"entryPressure is missing"});
}

TEST(FabricFile, NamesTheFile) {
    const TemporaryFolder folder;
    const auto why = [&](const std::string& name) {
        return refusal<std::runtime_error>([&] { readFabric(folder / name); });
    };
    EXPECT_NE(why("none.json").find("none.json: there is no such file"), std::string::npos);
    test::put(folder / "off.json", R"({"like": "cotton", "thickness": 3})");
    EXPECT_NE(why("off.json").find("off.json: thickness is 3"), std::string::npos) << why("off.json");
    EXPECT_NE(why(".").find("it is no file"), std::string::npos);
}

TEST(FabricFile, WritesNothingThatCannotBeRead) {
    const TemporaryFolder folder;
    const auto refused = [&](const Fabric& fabric) {
        return !refusal<std::invalid_argument>([&] { writeFabric(folder / "a.json", fabric); }).empty();
    };
    Fabric fabric;
    fabric.thickness = std::nan("");
    EXPECT_TRUE(refused(fabric));
    fabric = Fabric();
    fabric.name = "\xff\xfe";
    EXPECT_TRUE(refused(fabric));
    fabric = Fabric();
    fabric.shear = {60, Provenance::measured, ""};
    EXPECT_TRUE(refused(fabric));
    EXPECT_EQ(folder.files(), 0u);
}

TEST(FabricFile, ExampleInTheDocumentsIsRead) {
    const std::string page = test::contentsOf(DRENCH_SOURCE_DIR "/docs/files.md"), begin = "```json\n";
    const std::size_t from = page.find(begin) + begin.size();
    const Fabric towel = fabricFromText(page.substr(from, page.find("```", from) - from));
    EXPECT_EQ(towel.name, "bath towel");
    EXPECT_EQ(towel.arealDensity.value, 0.42);
    for (const FabricParameter& parameter : fabricParameters())
        EXPECT_NE(page.find("| " + std::string(parameter.unit) + " |"), std::string::npos) << parameter.unit;
}

TEST(FabricFile, SchemaInTheDocumentsIsTheLibrarys) {
    EXPECT_EQ(test::contentsOf(DRENCH_SOURCE_DIR "/docs/fabric.schema.json"), fabricSchema())
        << "write fabricSchema() there again";
}

// By Python's jsonschema, which knows nothing of this library.
TEST(FabricFile, SchemaTakesPresetsAndRefusesWhatIsOff) {
    ASSERT_EQ(std::system("python3 -c 'import jsonschema' 2> /dev/null"), 0) << "install python3-jsonschema";
    const TemporaryFolder folder;
    test::put(folder / "schema.json", fabricSchema());
    for (const std::string& name : fabrics::names())
        writeFabric(folder / ("right-" + name + ".json"), fabrics::byName(name));
    test::put(folder / "right-short.json",
              R"({"like": "cotton", "thickness": {"value": 0.3, "unit": "mm"}})");
    nlohmann::json withoutAngle = nlohmann::json::parse(fabricText(fabrics::silk()));
    withoutAngle.erase("contactAngle");
    test::put(folder / "right-without-angle.json", withoutAngle.dump());
    test::put(folder / "wrong-key.json", R"({"like": "cotton", "thicknes": 0.0003})");
    test::put(folder / "wrong-unit.json",
              R"({"like": "cotton", "thickness": {"value": 0.3, "unit": "g/m2"}})");
    test::put(folder / "wrong-range.json", R"({"like": "cotton", "thickness": 3})");
    test::put(folder / "wrong-like.json", R"({"like": "felt"})");
    test::put(folder / "wrong-source.json",
              R"({"like": "cotton", "thickness": {"value": 0.0003, "provenance": "measured"}})");
    test::put(folder / "wrong-missing.json", R"({"name": "thin", "thickness": 0.0003})");
    for (const auto& file : std::filesystem::directory_iterator(folder.path())) {
        const std::string name = file.path().filename().string();
        if (name == "schema.json") continue;
        // What other programs refuse, this one refuses too.
        EXPECT_EQ(refusal<std::runtime_error>([&] { readFabric(file.path()); }).empty(), name[0] == 'r')
            << name;
    }
    const std::string command =
        "python3 '" DRENCH_SOURCE_DIR "/tests/files/check_schema.py' '" + folder.path().string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
}

}  // namespace
}  // namespace drench::fabric_file_test
