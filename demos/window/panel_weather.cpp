#include <imgui/imgui.h>

#include <algorithm>

#include "hand/wetting.h"
#include "stage/stage.h"
#include "window/panel_groups.h"

namespace drench::demo {

namespace {

/// A slider for one value of the weather of all stages.
void changeWeather(const char* name, Weather& shown, double Weather::*value, double least, double most,
                   const char* format, Simulation& simulation) {
    if (!ImGui::SliderScalar(name, ImGuiDataType_Double, &(shown.*value), &least, &most, format,
                             ImGuiSliderFlags_AlwaysClamp))
        return;
    simulation.post([value, wanted = shown.*value](Scene& scene) {
        for (Stage* const stage : scene.stages()) stage->weather().*value = wanted;
    });
}

void changeWaterSpeed(const Snapshot& snapshot, PanelState& state, Simulation& simulation) {
    if (!ImGui::IsAnyItemActive() && !snapshot.sheets.empty())
        state.waterSpeed = snapshot.sheets[0].waterSpeed;
    constexpr double still = 0, fastest = 1000;
    if (ImGui::SliderScalar("times as fast", ImGuiDataType_Double, &state.waterSpeed, &still, &fastest,
                            "%.1f", ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp))
        simulation.post([speed = state.waterSpeed](Scene& scene) {
            for (Stage* const stage : scene.stages()) stage->setWaterSpeed(speed);
        });
}

void pourWater(Simulation& simulation) {
    if (ImGui::Button("soak: +50 g/m2"))
        simulation.post([](Scene& scene) {
            constexpr double portion = 0.05;  // kg/m2
            for (WetCloth* const cloth : wettable(scene)) cloth->soak(portion);
        });
}

/// The steps of the experiment: dry, and tenths of saturation.
void showWettingRow(PanelState& state, Simulation& simulation) {
    ImGui::TextUnformatted("tenths of what the pores hold:");
    for (int tenths = 0; tenths <= 10; ++tenths) {
        if (tenths > 0) ImGui::SameLine(0, 2);
        const bool chosen = state.wetting == tenths;
        if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        const std::string name = tenths == 0 ? "dry" : std::to_string(tenths);
        if (ImGui::SmallButton(name.c_str())) chooseWetting(state, tenths, simulation);
        if (chosen) ImGui::PopStyleColor();
    }
}

}  // namespace

void chooseWetting(PanelState& state, int tenths, Simulation& simulation) {
    state.wetting = std::clamp(tenths, 0, 10);
    simulation.post([share = state.wetting / 10.0](Scene& scene) { wetTo(scene, share); });
}

void showWeatherGroup(const Snapshot& snapshot, PanelState& state, Simulation& simulation) {
    if (!ImGui::CollapsingHeader("weather", ImGuiTreeNodeFlags_DefaultOpen)) return;
    if (!snapshot.weather) return ImGui::TextDisabled("this scene makes its own");
    // While the user drags a slider, what comes from the simulation is a little behind.
    if (!ImGui::IsAnyItemActive()) state.weather = *snapshot.weather;
    Weather& shown = state.weather;
    changeWeather("temperature", shown, &Weather::temperature, 0, 60, "%.0f °C", simulation);
    changeWeather("humidity", shown, &Weather::humidity, 0, 0.99, "%.2f", simulation);
    changeWeather("wind", shown, &Weather::windSpeed, 0, 20, "%.1f m/s", simulation);
    changeWeather("gusts", shown, &Weather::gusts, 0, 1, "%.2f", simulation);
    changeWeather("rain", shown, &Weather::rain, 0, 100, "%.0f mm/h", simulation);
}

void showWaterGroup(const Snapshot& snapshot, PanelState& state, Simulation& simulation) {
    if (!ImGui::CollapsingHeader("water", ImGuiTreeNodeFlags_DefaultOpen)) return;
    changeWaterSpeed(snapshot, state, simulation);
    showWettingRow(state, simulation);
    pourWater(simulation);
}

}  // namespace drench::demo
