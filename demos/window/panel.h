// The control panel over the picture.
#pragma once

#include <optional>
#include <string>

#include "description/scene_description.h"
#include "hand/pointer.h"
#include "run/simulation.h"
#include "stage/scene.h"
#include "window/readings.h"

namespace drench::demo {

// Kept when the window is resized, minimised or loses the focus, and when a scene is restarted.
struct PanelState {
    std::string scene;          // a name of `scenes()`
    SceneOptions options;       // for the next scene
    bool fabricChosen = false;  // whether the user has chosen it
    Weather weather;            // present values, or those of a dragged slider
    double waterSpeed = 1;      // the same
    int wetting = -1;           // the last chosen step of wetting, tenths; -1: none
    Tool tool = Tool::hand;
    View view = View::beauty;
    bool split = false;                         // dry and wet side by side
    std::optional<SceneDescription> described;  // a scene from a file; none: one of `scenes()`
    std::string file = "scene.json";            // file to save to and load from
    bool shown = true;
    bool helpShown = false;
    std::string notice;  // shown beside the readings; empty: none
};

// Shows the state of a simulation, and lets the user change it, within ImGui frames.
class Panel {
  public:
    // @param renderer  name of the OpenGL driver
    explicit Panel(const std::string& renderer) : readings_(renderer) {}

    // Shows the panel, if enabled, and messages. Changes that do not require a new scene are posted to the
    // simulation at once.
    // @return whether the scene must be restarted, with the options in the state
    bool show(const FrameState& now, PanelState& state, Simulation& simulation);
    // Registers the time for drawing the last picture, s.
    void noteDrawTime(double seconds) { readings_.noteDrawTime(seconds); }

  private:
    Readings readings_;
};

// Selects the scene `step` entries further in the list, cyclically.
void chooseNeighbour(PanelState& state, int step);

// Selects the next view, cyclically.
void nextView(PanelState& state, Simulation& simulation);

// Sets the saturation of all sheets, in tenths, 0 to 10.
void chooseWetting(PanelState& state, int tenths, Simulation& simulation);

}  // namespace drench::demo
