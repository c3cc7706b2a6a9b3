#include "window/readings.h"

#include <imgui/imgui.h>

#include <algorithm>

namespace drench::demo {

namespace {

constexpr double waterSampling = 0.2;      // s of the scene between samples of the water
constexpr std::size_t waterSamples = 300;  // a minute
constexpr std::size_t timeSamples = 240;   // frames
constexpr std::size_t averagedFrames = 30;

// Whether OpenGL is rendered in software.
bool isSoftware(const std::string& renderer) {
    for (const char* const name : {"llvmpipe", "softpipe", "SWR", "Software Rasterizer", "swrast"})
        if (renderer.find(name) != std::string::npos) return true;
    return false;
}

std::vector<double> waterOf(const FrameState& now) {
    double pores = 0, film = 0, dripped = 0, evaporated = 0, returned = 0;
    for (const SheetReading& sheet : now.sheets) {
        pores += sheet.pores;
        film += sheet.film;
        dripped += sheet.ledger.dripped;
        evaporated += sheet.ledger.evaporated;
        returned += sheet.ledger.returned;
    }
    constexpr double grams = 1e3;
    return {grams * pores, grams * film, grams * dripped, grams * evaporated, grams * returned};
}

std::vector<double> millisecondsOf(const FrameTimes& times, double drawing) {
    const double named = times.supply + times.water + times.laws + times.air + times.contacts + times.solver;
    const double rest = std::max(0.0, times.all - named);
    std::vector<double> stages = {times.supply,   times.water,  times.laws, times.air,
                                  times.contacts, times.solver, rest,       drawing};
    for (double& stage : stages) stage *= 1e3;
    return stages;
}

}  // namespace

Readings::Readings(const std::string& renderer)
    : renderer_(isSoftware(renderer) ? "software renderer: " + renderer : renderer),
      water_({{"in pores", {0.25f, 0.45f, 0.85f}},
              {"in film", {0.45f, 0.75f, 0.95f}},
              {"dripped", {0.55f, 0.55f, 0.60f}},
              {"evaporated", {0.90f, 0.70f, 0.35f}},
              {"returned", {0.60f, 0.45f, 0.70f}}},
             waterSamples, "g", "%8.2f"),
      times_({{"supply", {0.45f, 0.75f, 0.95f}},
              {"water", {0.25f, 0.45f, 0.85f}},
              {"laws", {0.60f, 0.45f, 0.70f}},
              {"air", {0.80f, 0.85f, 0.90f}},
              {"contacts", {0.85f, 0.45f, 0.35f}},
              {"solver", {0.90f, 0.70f, 0.35f}},
              {"other", {0.50f, 0.50f, 0.50f}},
              {"drawing", {0.40f, 0.70f, 0.40f}}},
             timeSamples, "ms", "%7.2f") {}

void Readings::note(const FrameState& now) {
    if (now.run != run_) {
        run_ = now.run;
        frame_ = -1;
        sampled_ = -waterSampling;
        water_.clear();
        times_.clear();
    }
    if (now.frame == frame_) return;
    frame_ = now.frame;
    times_.add(millisecondsOf(now.times, drawTime_));
    if (now.time < sampled_ + waterSampling) return;
    sampled_ = now.time;
    water_.add(waterOf(now));
}

void Readings::show(const FrameState& now, const std::string& notice) const {
    ImGui::Text("%.0f pictures/s, %.0f frames/s simulated", double(ImGui::GetIO().Framerate),
                now.framesPerSecond);
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", renderer_.c_str());
    ImGui::PopTextWrapPos();
    for (const std::string& each : {notice, now.notice})
        if (!each.empty()) ImGui::TextWrapped("%s", each.c_str());
    if (ImGui::CollapsingHeader("water, the last minute", ImGuiTreeNodeFlags_DefaultOpen))
        water_.draw(7 * ImGui::GetFontSize());
    if (ImGui::CollapsingHeader("time of a frame", ImGuiTreeNodeFlags_DefaultOpen))
        times_.draw(5.5f * ImGui::GetFontSize(), averagedFrames);
    if (!ImGui::CollapsingHeader("sheets")) return;
    for (const SheetReading& sheet : now.sheets)
        ImGui::Text("%s: %.3f kg dry, %.1f g water\n  %.0f %% of saturation, ledger open by %.1e kg",
                    sheet.name.c_str(), sheet.dryMass, 1e3 * (sheet.pores + sheet.film),
                    100 * sheet.saturation, sheet.ledger.imbalance());
}

}  // namespace drench::demo
