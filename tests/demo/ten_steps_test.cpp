#include "scenes/ten_steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "run/runners.h"

namespace drench::demo::ten_steps_test {
namespace {

// The whole experiment on a sheet of 28 x 23 nodes, run once for all tests of this file.
const TenSteps& coarseRun() {
    static const std::unique_ptr<TenSteps> run = [] {
        SceneOptions options;
        options.resolution = 28;
        auto scene = std::make_unique<TenSteps>(options);
        while (!scene->finished()) scene->advance();
        return scene;
    }();
    return *run;
}

double value(const Table& table, std::size_t row, const std::string& column) {
    for (std::size_t c = 0; c < table.columns.size(); ++c)
        if (table.columns[c].name == column) return table.rows.at(row).at(c);
    ADD_FAILURE() << "no column " << column;
    return 0;
}

TEST(TenSteps, HasTheColumnsOfTheExperiment) {
    std::string names;
    for (const Column& column : coarseRun().table().columns) names += column.name + " ";
    EXPECT_EQ(
        names,
        "step water_g_per_node sheet_mass_kg mass_ratio sag_m mean_strain wind_deflection_deg swing_period_s "
        "albedo sim_fps frame_fps ");
    EXPECT_EQ(coarseRun().table().rows.size(), 11u);
}

TEST(TenSteps, SagAndStrainGrowAndColourAndDeflectionFallWithEveryStep) {
    const Table table = coarseRun().table();
    for (std::size_t step = 1; step <= 10; ++step) {
        EXPECT_GT(value(table, step, "sag_m"), value(table, step - 1, "sag_m")) << step;
        EXPECT_GT(value(table, step, "mean_strain"), value(table, step - 1, "mean_strain")) << step;
        EXPECT_LT(value(table, step, "albedo"), value(table, step - 1, "albedo")) << step;
        EXPECT_LT(value(table, step, "wind_deflection_deg"), value(table, step - 1, "wind_deflection_deg"))
            << step;
    }
    const auto failures = coarseRun().failures();
    EXPECT_TRUE(failures.empty()) << failures.front();
}

TEST(TenSteps, EachStepWeighsTheSheetPlusItsDocumentedWater) {
    // 54 x 44 cells, each with the water of one inner node: 0.010 + 0.083 n grams.
    const Table table = coarseRun().table();
    const double dry = value(table, 0, "sheet_mass_kg");
    EXPECT_NEAR(dry, 0.150 * 54 * 44 * 0.840e-3 / fabrics::cottonPlain().poreCapacity(), 1e-6 * dry);
    for (int step = 1; step <= 10; ++step) {
        const double water = 54 * 44 * (0.010e-3 + 0.083e-3 * step);
        EXPECT_NEAR(value(table, std::size_t(step), "sheet_mass_kg"), dry + water, 1e-6 * (dry + water))
            << step;
    }
}

TEST(TenSteps, AnInnerNodeOfTheFullGridTakesTheDocumentedGrams) {
    SceneOptions options;
    TenSteps scene(options);
    // The first step that has water, before any mechanics: 0.093 g per inner node is 0.093 / 0.840 of
    // saturation.
    const double cell = 0.840e-3 / fabrics::cottonPlain().poreCapacity();
    const Moisture& moisture = scene.sheets()[0].cloth->moisture();
    EXPECT_NEAR(moisture.area(27 + 55 * 22), cell, 1e-8);
    EXPECT_NEAR(moisture.poreCapacity(27 + 55 * 22), 0.840e-3, 1e-9);
}

TEST(TenSteps, TheReportPutsFiveStepsSideBySide) {
    std::ostringstream text;
    coarseRun().report(text);
    EXPECT_NE(text.str().find("side by side"), std::string::npos);
    EXPECT_NE(text.str().find("Small steps per frame"), std::string::npos);
}

// A scene that is over at once and says that something is wrong, or not.
class Verdict final : public Scene {
  public:
    explicit Verdict(bool good) : good_(good) {}
    void advance() override {}
    bool finished() const override { return true; }
    double progress() const override { return 1; }
    std::string status() const override { return ""; }
    viewer::Picture picture(View) const override { return {}; }
    std::vector<Stage*> stages() override { return {}; }
    void report(std::ostream&) const override {}
    std::vector<std::string> failures() const override {
        return good_ ? std::vector<std::string>{} : std::vector<std::string>{"something is wrong"};
    }

  private:
    bool good_;
};

TEST(RunHeadless, ExitsWithOneWhenTheScenesCheckFails) {
    Verdict good(true), bad(false);
    EXPECT_EQ(runHeadless(good, {}), 0);
    EXPECT_EQ(runHeadless(bad, {}), 1);
}

}  // namespace
}  // namespace drench::demo::ten_steps_test
