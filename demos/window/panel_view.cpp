#include <imgui/imgui.h>

#include <iterator>

#include "window/panel_groups.h"

namespace drench::demo {

bool showViewGroup(PanelState& state, Simulation& simulation) {
    if (!ImGui::CollapsingHeader("view", ImGuiTreeNodeFlags_DefaultOpen)) return false;
    constexpr const char* names[] = {"beauty", "water content", "film", "strain"};
    int chosen = int(state.view);
    if (ImGui::Combo("show", &chosen, names, int(std::size(names)))) {
        state.view = View(chosen);
        simulation.setView(state.view);
    }
    return ImGui::Checkbox("split: dry and wet", &state.split);
}

void nextView(PanelState& state, Simulation& simulation) {
    constexpr int views = 4;
    state.view = View((int(state.view) + 1) % views);
    simulation.setView(state.view);
}

}  // namespace drench::demo
