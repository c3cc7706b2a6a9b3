// The panel over the picture: what to watch and what to change.
#pragma once

#include <optional>
#include <string>

#include "description/scene_description.h"
#include "hand/pointer.h"
#include "run/simulation.h"
#include "stage/scene.h"
#include "window/readings.h"

namespace drench::demo {

// Stays as it is when the window is resized, minimised or left, and when a scene begins anew.
struct PanelState {
    std::string scene;          // a name of `scenes()`
    SceneOptions options;       // for the next scene that is made
    bool fabricChosen = false;  // by the user, rather than by the scene
    Weather weather;            // as it is, or as sliders under the mouse have it
    double waterSpeed = 1;      // the same
    int wetting = -1;           // the step of wetting chosen last, tenths; -1: none
    Tool tool = Tool::hand;
    View view = View::beauty;
    bool split = false;                         // dry and wet side by side
    std::optional<SceneDescription> described;  // a scene from a file; none: one of `scenes()`
    std::string file = "scene.json";            // to save to and load from
    bool shown = true;
    bool helpShown = false;
    std::string notice;  // to be seen beside the readings; empty: none
};

// Shows what a simulation does and lets the user change it, within ImGui frames.
class Panel {
  public:
    // @param renderer  what OpenGL draws with, as the driver names it
    explicit Panel(const std::string& renderer) : readings_(renderer) {}

    // Shows the panel, if the state wants it, and what must be seen in any case. Changes that do not need a
    // new scene are posted to the simulation at once.
    // @return whether the scene is to begin anew, as the state says
    bool show(const FrameState& now, PanelState& state, Simulation& simulation);
    // Notes how long the last picture took to draw, s.
    void noteDrawTime(double seconds) { readings_.noteDrawTime(seconds); }

  private:
    Readings readings_;
};

// Chooses the scene so many places further on the list, round its ends.
void chooseNeighbour(PanelState& state, int step);

// Shows the sheets in the next way, round the end.
void nextView(PanelState& state, Simulation& simulation);

// Gives all sheets so many tenths of what their pores hold, 0 to 10.
void chooseWetting(PanelState& state, int tenths, Simulation& simulation);

}  // namespace drench::demo
