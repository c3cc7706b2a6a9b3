// The scenes of contact, wind and water, by the tables that they write.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "run/water_log.h"
#include "scenes/registry.h"
#include "stage/scene.h"
#include "world/angles.h"

namespace drench::demo::touch_scenes_test {
namespace {

// Runs a scene to its end, expects its own check to pass, and returns its log.
Table logOf(const std::string& name, double seconds = 0) {
    SceneOptions options;
    options.fabric = sceneByName(name).fabric;
    options.seconds = seconds;
    const std::unique_ptr<Scene> scene = makeScene(name, options);
    WaterLog log(*scene);
    while (!scene->finished()) {
        scene->advance();
        log.note(*scene);
    }
    for (const std::string& failure : scene->failures()) ADD_FAILURE() << name << ": " << failure;
    return log.table();
}

std::vector<double> column(const Table& table, const std::string& name) {
    std::vector<double> values;
    for (std::size_t c = 0; c < table.columns.size(); ++c)
        if (table.columns[c].name == name)
            for (const auto& row : table.rows) values.push_back(row.at(c));
    EXPECT_FALSE(values.empty()) << "no column " << name;
    return values;
}

// Middle of the spectrum of what happens after the first seconds, Hz.
double meanFrequency(std::vector<double> values, double from) {
    values.erase(values.begin(), values.begin() + std::lround(from / Scene::frameTime));
    double mean = 0;
    for (const double value : values) mean += value / double(values.size());
    double power = 0, moment = 0;
    for (std::size_t k = 1; k < values.size() / 4; ++k) {
        double cosine = 0, sine = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double angle = 2 * pi * double(k) * double(i) / double(values.size());
            cosine += (values[i] - mean) * std::cos(angle);
            sine += (values[i] - mean) * std::sin(angle);
        }
        power += cosine * cosine + sine * sine;
        moment += (cosine * cosine + sine * sine) * double(k);
    }
    return moment / power / (double(values.size()) * Scene::frameTime);
}

TEST(TouchScenes, AWetFlagFlapsMoreSlowlyAndHangsLower) {
    const Table log = logOf("flag", 24);
    const double dry = meanFrequency(column(log, "dry_z_m"), 4),
                 wet = meanFrequency(column(log, "wet_z_m"), 4);
    RecordProperty("dry_hz", std::to_string(dry));
    RecordProperty("wet_hz", std::to_string(wet));
    EXPECT_LT(wet, 0.85 * dry) << dry << " Hz dry, " << wet << " Hz wet";
    EXPECT_LT(column(log, "wet_mean_chord_deg").back(), column(log, "dry_mean_chord_deg").back());
}

TEST(TouchScenes, ATurningBallCarriesTheWetSheetOnly) {
    const Table log = logOf("cling");
    EXPECT_NEAR(column(log, "wet_deg").back() / column(log, "ball_deg").back(), 1, 0.03);
    EXPECT_LT(column(log, "dry_deg").back(), 0.5 * column(log, "ball_deg").back());
    EXPECT_EQ(column(log, "dry_contact").back(), 0);
}

TEST(TouchScenes, OnASlopeDrySlidesDampHoldsAndSoakedSlides) {
    const Table log = logOf("slide");
    // Before the air matters: 1/2 g (sin 20 - 0.2 cos 20) t^2 at 0.5 s.
    EXPECT_NEAR(column(log, "dry_m")[29], 0.5 * 9.81 * (std::sin(pi / 9) - 0.2 * std::cos(pi / 9)) * 0.25,
                0.008);
    EXPECT_LT(column(log, "damp_m").back(), 1e-3);
    EXPECT_GT(column(log, "soaked_m").back(), 0.5);
}

TEST(TouchScenes, ASheetComesOutOfThePoolWithWhatTheLedgerSays) {
    const Table log = logOf("pool");
    const double held = column(log, "pore_kg").back() + column(log, "film_kg").back();
    EXPECT_NEAR(column(log, "supplied_kg").back(),
                held + column(log, "dripped_kg").back() + column(log, "evaporated_kg").back() +
                    column(log, "returned_kg").back(),
                1e-9);
    EXPECT_NEAR(column(log, "mass_kg").back(), 0.045 + held, 1e-7);
    EXPECT_GT(column(log, "dripped_kg").back(), 0);
}

}  // namespace
}  // namespace drench::demo::touch_scenes_test
