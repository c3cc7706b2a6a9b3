#include <imgui/imgui.h>

#include <array>
#include <exception>

#include "description/scene_file.h"
#include "window/panel_groups.h"

namespace drench::demo {

namespace {

void editName(std::string& file) {
    std::array<char, 512> text{};
    file.copy(text.data(), text.size() - 1);
    if (ImGui::InputText("file", text.data(), text.size())) file = text.data();
}

/// @return whether there is a scene to begin
bool load(PanelState& state) {
    try {
        state.described = loadScene(state.file);
    } catch (const std::exception& problem) {
        state.notice = problem.what();
        return false;
    }
    state.scene = state.described->name;
    state.options.fabric.clear();
    state.fabricChosen = false;
    state.options.resolution = 0;
    state.options.world = state.described->solver.world;
    state.options.solver = state.described->solver.solver;
    state.options.smallSteps.reset();
    state.options.seed = state.described->seed;
    state.notice = "read " + state.file;
    return true;
}

}  // namespace

bool showFileGroup(PanelState& state, Simulation& simulation) {
    if (!ImGui::CollapsingHeader("scene file")) return false;
    editName(state.file);
    if (ImGui::Button("save")) simulation.save(state.file);
    ImGui::SameLine();
    return ImGui::Button("load") && load(state);
}

}  // namespace drench::demo
