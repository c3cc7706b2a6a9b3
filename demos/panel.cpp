#include "panel.h"

#include <imgui/imgui.h>

namespace drench::demo {

namespace {

bool pickFabric(std::string& name) {
    bool changed = false;
    if (!ImGui::BeginCombo("fabric", name.c_str())) return false;
    for (const std::string& candidate : fabrics::names())
        if (ImGui::Selectable(candidate.c_str(), candidate == name) && candidate != name) {
            name = candidate;
            changed = true;
        }
    ImGui::EndCombo();
    return changed;
}

void changeWind(double& speed) {
    constexpr double still = 0, storm = 15;
    ImGui::SliderScalar("m/s wind, when it blows", ImGuiDataType_Double, &speed, &still, &storm, "%.1f");
}

void pourWater(const std::vector<SceneSheet>& sheets) {
    constexpr double portion = 0.05;  // kg/m2
    if (!ImGui::Button("soak: +50 g/m2")) return;
    for (const SceneSheet& sheet : sheets) sheet.cloth->soak(portion);
}

void showLedger(const SceneSheet& sheet) {
    const Ledger ledger = sheet.cloth->ledger();
    const Moisture& moisture = sheet.cloth->moisture();
    ImGui::Separator();
    ImGui::Text("%s: %.3f kg cloth", sheet.name.c_str(), sheet.cloth->dryMass());
    ImGui::Text("  supplied   %8.4f kg", ledger.supplied);
    ImGui::Text("  in pores   %8.4f kg", moisture.totalPoreMass());
    ImGui::Text("  in film    %8.4f kg", moisture.totalFilmMass());
    ImGui::Text("  dripped    %8.4f kg", ledger.dripped);
    ImGui::Text("  evaporated %8.4f kg", ledger.evaporated);
    ImGui::Text("  returned   %8.4f kg", ledger.returned);
}

}  // namespace

PanelWishes showPanel(Scene& scene, SceneOptions& options, bool paused) {
    PanelWishes wishes;
    ImGui::SetNextWindowPos({12, 90}, ImGuiCond_Once);
    ImGui::Begin("drench", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::TextUnformatted(scene.status().c_str());
    ImGui::ProgressBar(float(scene.progress()));
    wishes.togglePause = ImGui::Button(paused ? "go on (space)" : "pause (space)");
    ImGui::SameLine();
    wishes.step = ImGui::Button("step (.)");
    ImGui::SameLine();
    wishes.restart = ImGui::Button("reset (r)");
    wishes.restart |= pickFabric(options.fabric);
    changeWind(scene.windSpeed());
    pourWater(scene.sheets());
    for (const SceneSheet& sheet : scene.sheets()) showLedger(sheet);
    ImGui::Separator();
    ImGui::Text("%.0f frames/s", double(ImGui::GetIO().Framerate));
    ImGui::End();
    return wishes;
}

}  // namespace drench::demo
