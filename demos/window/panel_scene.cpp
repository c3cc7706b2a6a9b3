#include <imgui/imgui.h>

#include <algorithm>

#include "scenes/registry.h"
#include "window/panel_groups.h"

namespace drench::demo {

namespace {

bool pickScene(PanelState& state) {
    bool changed = false;
    if (!ImGui::BeginCombo("scene", state.scene.c_str(), ImGuiComboFlags_HeightLarge)) return false;
    for (const SceneEntry& entry : scenes()) {
        const bool isShown = entry.name == state.scene && !state.described;
        if (ImGui::Selectable(entry.name.c_str(), isShown) && !isShown) {
            chooseScene(state, entry);
            changed = true;
        }
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", entry.description.c_str());
    }
    ImGui::EndCombo();
    return changed;
}

bool pickFabric(PanelState& state) {
    bool changed = false;
    const std::string& shown = state.options.fabric;
    if (!ImGui::BeginCombo("fabric", shown.empty() ? "scene's own" : shown.c_str())) return false;
    for (const std::string& candidate : fabrics::names())
        if (ImGui::Selectable(candidate.c_str(), candidate == state.options.fabric) &&
            candidate != state.options.fabric) {
            state.options.fabric = candidate;
            state.fabricChosen = changed = true;
        }
    ImGui::EndCombo();
    return changed;
}

/// @return whether the user has let go of another value than there was
bool pickCount(const char* name, int& value, int least, int most, const char* noneName) {
    ImGui::SliderInt(name, &value, 0, most, value == 0 ? noneName : "%d", ImGuiSliderFlags_AlwaysClamp);
    if (value > 0) value = std::max(value, least);
    return ImGui::IsItemDeactivatedAfterEdit();
}

bool pickSolver(PanelState& state) {
    SceneOptions& options = state.options;
    constexpr const char* names[] = {"small steps", "stock Bullet", "deformable world"};
    int chosen = options.world == WorldKind::deformable ? 2 : options.solver == SolverKind::stock ? 1 : 0;
    bool changed = false;
    if (ImGui::Combo("solver", &chosen, names, int(std::size(names)))) {
        options.world = chosen == 2 ? WorldKind::deformable : WorldKind::softRigid;
        options.solver = chosen == 0 ? SolverKind::smallStep : SolverKind::stock;
        changed = true;
    }
    if (chosen != 0) return changed;
    int count = options.smallSteps.value_or(0);
    if (pickCount("small steps", count, 1, 200, "automatic")) {
        options.smallSteps = count > 0 ? std::optional<int>(count) : std::nullopt;
        changed = true;
    } else if (ImGui::IsItemActive()) {
        state.options.smallSteps = count;
    }
    return changed;
}

void chooseSpeed(Simulation& simulation) {
    bool fast = simulation.speed() == 0;
    double speed = fast ? 1 : simulation.speed();
    constexpr double slowest = 0.05, fastest = 8;
    if (ImGui::Checkbox("as fast as it can", &fast)) simulation.setSpeed(fast ? 0 : 1);
    if (fast) return;
    if (ImGui::SliderScalar("speed", ImGuiDataType_Double, &speed, &slowest, &fastest, "%.2f",
                            ImGuiSliderFlags_Logarithmic))
        simulation.setSpeed(std::clamp(speed, slowest, fastest));
}

bool showRunning(const Snapshot& snapshot, Simulation& simulation) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(snapshot.status.c_str());
    ImGui::PopTextWrapPos();
    ImGui::ProgressBar(float(snapshot.progress), {-1, 0.3f * ImGui::GetFontSize()}, "");
    const bool paused = simulation.paused();
    if (ImGui::Button(paused ? "go on" : "pause")) simulation.setPaused(!paused);
    ImGui::SameLine();
    if (ImGui::Button("step")) simulation.step();
    ImGui::SameLine();
    const bool restart = ImGui::Button("reset");
    if (snapshot.ended) {
        ImGui::SameLine();
        ImGui::TextDisabled("ended, plays on");
    }
    return restart;
}

}  // namespace

bool showSceneGroup(const Snapshot& snapshot, PanelState& state, Simulation& simulation) {
    bool restart = showRunning(snapshot, simulation);
    if (!ImGui::CollapsingHeader("scene", ImGuiTreeNodeFlags_DefaultOpen)) return restart;
    restart |= pickScene(state);
    restart |= pickFabric(state);
    restart |= pickCount("nodes", state.options.resolution, 8, 160, "scene's own");
    restart |= pickSolver(state);
    chooseSpeed(simulation);
    return restart;
}

void chooseScene(PanelState& state, const SceneEntry& entry) {
    state.scene = entry.name;
    state.described.reset();
    if (!state.fabricChosen) state.options.fabric = entry.fabric;
    if (!entry.runsDeformable && state.options.world == WorldKind::deformable) {
        state.options.world = WorldKind::softRigid;
        state.options.solver = SolverKind::smallStep;
    }
}

}  // namespace drench::demo
