#include "window/panel.h"

#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <exception>
#include <iterator>

#include "description/scene_file.h"
#include "hand/wetting.h"
#include "scenes/registry.h"
#include "stage/stage.h"

namespace drench::demo {

namespace {

// With its default fabric, unless the user has chosen one.
void chooseScene(PanelState& state, const SceneEntry& entry) {
    state.scene = entry.name;
    state.described.reset();
    if (!state.fabricChosen) state.options.fabric = entry.fabric;
    if (!entry.runsDeformable && state.options.world == WorldKind::deformable) {
        state.options.world = WorldKind::softRigid;
        state.options.solver = SolverKind::smallStep;
    }
}

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

// @return whether the user has released the slider at a different value
bool pickCount(const char* name, int& value, int min, int max, const char* noneName) {
    ImGui::SliderInt(name, &value, 0, max, value == 0 ? noneName : "%d", ImGuiSliderFlags_AlwaysClamp);
    if (value > 0) value = std::max(value, min);
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

bool showRunning(const FrameState& now, Simulation& simulation) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(now.status.c_str());
    ImGui::PopTextWrapPos();
    ImGui::ProgressBar(float(now.progress), {-1, 0.3f * ImGui::GetFontSize()}, "");
    const bool paused = simulation.paused();
    if (ImGui::Button(paused ? "go on" : "pause")) simulation.setPaused(!paused);
    ImGui::SameLine();
    if (ImGui::Button("step")) simulation.step();
    ImGui::SameLine();
    const bool restart = ImGui::Button("reset");
    if (now.ended) {
        ImGui::SameLine();
        ImGui::TextDisabled("ended, plays on");
    }
    return restart;
}

// Scene, fabric, solver and speed. @return whether the scene must be restarted
bool showSceneGroup(const FrameState& now, PanelState& state, Simulation& simulation) {
    bool restart = showRunning(now, simulation);
    if (!ImGui::CollapsingHeader("scene", ImGuiTreeNodeFlags_DefaultOpen)) return restart;
    restart |= pickScene(state);
    restart |= pickFabric(state);
    restart |= pickCount("nodes", state.options.resolution, 8, 160, "scene's own");
    restart |= pickSolver(state);
    chooseSpeed(simulation);
    return restart;
}

// A slider for one value of the weather of all stages.
void changeWeather(const char* name, Weather& shown, double Weather::*value, double min, double max,
                   const char* format, Simulation& simulation) {
    if (!ImGui::SliderScalar(name, ImGuiDataType_Double, &(shown.*value), &min, &max, format,
                             ImGuiSliderFlags_AlwaysClamp))
        return;
    simulation.post([value, wanted = shown.*value](Scene& scene) {
        for (Stage* const stage : scene.stages()) stage->weather().*value = wanted;
    });
}

void changeWaterSpeed(const FrameState& now, PanelState& state, Simulation& simulation) {
    if (!ImGui::IsAnyItemActive() && !now.sheets.empty()) state.waterSpeed = now.sheets[0].waterSpeed;
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
            for (WetCloth* const cloth : wettable(scene)) cloth->soakFilm(portion);
        });
}

// Buttons for the steps of the experiment: dry, and tenths of saturation.
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

// Air, wind and rain.
void showWeatherGroup(const FrameState& now, PanelState& state, Simulation& simulation) {
    if (!ImGui::CollapsingHeader("weather", ImGuiTreeNodeFlags_DefaultOpen)) return;
    if (!now.weather) return ImGui::TextDisabled("this scene makes its own");
    // While the user drags a slider, the values of the simulation are slightly delayed.
    if (!ImGui::IsAnyItemActive()) state.weather = *now.weather;
    Weather& shown = state.weather;
    changeWeather("temperature", shown, &Weather::temperature, 0, 60, "%.0f °C", simulation);
    changeWeather("humidity", shown, &Weather::humidity, 0, 0.99, "%.2f", simulation);
    changeWeather("wind", shown, &Weather::windSpeed, 0, 20, "%.1f m/s", simulation);
    changeWeather("gusts", shown, &Weather::gusts, 0, 1, "%.2f", simulation);
    changeWeather("rain", shown, &Weather::rain, 0, 100, "%.0f mm/h", simulation);
}

// The speed of water, and buttons that add or remove water.
void showWaterGroup(const FrameState& now, PanelState& state, Simulation& simulation) {
    if (!ImGui::CollapsingHeader("water", ImGuiTreeNodeFlags_DefaultOpen)) return;
    changeWaterSpeed(now, state, simulation);
    showWettingRow(state, simulation);
    pourWater(simulation);
}

// The action of the left mouse button on cloth.
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

// The view of the sheets. @return whether the scene must be restarted
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

void editName(std::string& file) {
    std::array<char, 512> text{};
    file.copy(text.data(), text.size() - 1);
    if (ImGui::InputText("file", text.data(), text.size())) file = text.data();
}

// @return whether there is a scene to start
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

// Saves the scene to a file, or loads one. @return whether the scene must be restarted
bool showFileGroup(PanelState& state, Simulation& simulation) {
    if (!ImGui::CollapsingHeader("scene file")) return false;
    editName(state.file);
    if (ImGui::Button("save")) simulation.save(state.file);
    ImGui::SameLine();
    return ImGui::Button("load") && load(state);
}

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

// Keys and mouse, in a separate window, which the user may close.
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

// Errors, in a separate window. @return whether the scene must be restarted
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

}  // namespace

bool Panel::show(const FrameState& now, PanelState& state, Simulation& simulation) {
    readings_.note(now);
    bool restart = false;
    if (!now.trouble.empty()) restart = showTrouble(now.trouble);
    if (state.helpShown) showHelp(state.helpShown);
    if (!state.shown) return restart;

    // In widths of a letter, which has more pixels on high-resolution screens.
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float letter = ImGui::GetFontSize();
    const float top = 7 * letter, margin = 0.8f * letter, width = 23 * letter;
    const ImVec2 min(width, 0), max(width, std::max(8 * letter, screen.y - top - margin));
    ImGui::SetNextWindowPos({margin, top}, ImGuiCond_Once);
    ImGui::SetNextWindowSizeConstraints(min, max);
    if (ImGui::Begin("drench", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
        ImGui::PushItemWidth(10.5f * letter);
        restart |= showSceneGroup(now, state, simulation);
        showWeatherGroup(now, state, simulation);
        showWaterGroup(now, state, simulation);
        showToolGroup(state);
        restart |= showViewGroup(state, simulation);
        restart |= showFileGroup(state, simulation);
        ImGui::PopItemWidth();
    }
    ImGui::End();

    ImGui::SetNextWindowPos({screen.x - margin, top}, ImGuiCond_Always, {1, 0});
    ImGui::SetNextWindowSizeConstraints(min, max);
    if (ImGui::Begin("readings", nullptr, ImGuiWindowFlags_AlwaysAutoResize))
        readings_.show(now, state.notice);
    ImGui::End();
    return restart;
}

void chooseNeighbour(PanelState& state, int step) {
    const int count = int(scenes().size());
    if (count == 0) return;
    int index = 0;
    while (index < count && scenes()[std::size_t(index)].name != state.scene) ++index;
    const SceneEntry& next = scenes()[std::size_t((index + step + count) % count)];
    chooseScene(state, next);
}

void nextView(PanelState& state, Simulation& simulation) {
    constexpr int views = 4;
    state.view = View((int(state.view) + 1) % views);
    simulation.setView(state.view);
}

void chooseWetting(PanelState& state, int tenths, Simulation& simulation) {
    state.wetting = std::clamp(tenths, 0, 10);
    simulation.post([fraction = state.wetting / 10.0](Scene& scene) { wetTo(scene, fraction); });
}

}  // namespace drench::demo
