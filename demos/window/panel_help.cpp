#include <imgui/imgui.h>

#include "window/panel_groups.h"

namespace drench::demo {

namespace {

struct Line {
    const char* keys;
    const char* meaning;
};

constexpr Line lines[] = {
    {"left drag on cloth", "hold it and take it along"},
    {"left drag elsewhere", "orbit"},
    {"right drag, wheel", "pan, zoom"},
    {"H + left", "hose: spray water at the cloth"},
    {"D + left", "towel: dab the cloth dry"},
    {"space or P", "pause, go on"},
    {". or right arrow", "one frame more"},
    {"R", "reset the scene"},
    {"page down, page up", "next scene, the one before"},
    {"up, down", "a tenth wetter, a tenth drier"},
    {"V", "next view: beauty, content, film, strain"},
    {"S", "split the picture: dry and wet"},
    {"Tab", "hide or show the panel"},
    {"F1", "this list"},
    {"F9", "begin or end a film"},
    {"F12", "keep the picture as a PNG file"},
    {"Escape", "close"},
};

ImVec2 middle() {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    return {screen.x / 2, screen.y / 2};
}

}  // namespace

void showHelp(bool& shown) {
    ImGui::SetNextWindowPos(middle(), ImGuiCond_Appearing, {0.5f, 0.5f});
    if (ImGui::Begin("keys and mouse", &shown,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse))
        for (const Line& line : lines) {
            ImGui::TextUnformatted(line.keys);
            ImGui::SameLine(12 * ImGui::GetFontSize());
            ImGui::TextUnformatted(line.meaning);
        }
    ImGui::End();
}

bool showTrouble(const std::string& trouble) {
    bool restart = false;
    ImGui::SetNextWindowPos(middle(), ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({30 * ImGui::GetFontSize(), 0});
    if (ImGui::Begin("the scene has stopped", nullptr, ImGuiWindowFlags_NoCollapse)) {
        ImGui::TextWrapped("%s", trouble.c_str());
        restart = ImGui::Button("reset (R)");
    }
    ImGui::End();
    return restart;
}

void showToolGroup(PanelState& state) {
    if (!ImGui::CollapsingHeader("mouse, left button on cloth", ImGuiTreeNodeFlags_DefaultOpen)) return;
    const auto choose = [&](const char* name, Tool tool) {
        if (ImGui::RadioButton(name, state.tool == tool)) state.tool = tool;
    };
    choose("hold", Tool::hand);
    ImGui::SameLine();
    choose("hose (H)", Tool::hose);
    ImGui::SameLine();
    choose("towel (D)", Tool::towel);
}

}  // namespace drench::demo
