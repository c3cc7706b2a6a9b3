// The parts of the panel, each to be called within an ImGui window.
#pragma once

#include "run/simulation.h"
#include "run/snapshot.h"
#include "window/panel_state.h"

namespace drench::demo {

/// Which scene, fabric and solver, and how it runs. @return whether the scene is to begin anew
bool showSceneGroup(const Snapshot& snapshot, PanelState& state, Simulation& simulation);

/// Air, wind and rain.
void showWeatherGroup(const Snapshot& snapshot, PanelState& state, Simulation& simulation);

/// The speed of water, and water at a stroke.
void showWaterGroup(const Snapshot& snapshot, PanelState& state, Simulation& simulation);

/// What the picture shows of the sheets. @return whether the scene is to begin anew
bool showViewGroup(PanelState& state, Simulation& simulation);

/// Shows the sheets in the next way, round the end.
void nextView(PanelState& state, Simulation& simulation);

/// Saves the scene to a file, or loads one. @return whether the scene is to begin anew
bool showFileGroup(PanelState& state, Simulation& simulation);

/// Gives all sheets so many tenths of what their pores hold, 0 to 10.
void chooseWetting(PanelState& state, int tenths, Simulation& simulation);

/// What the left mouse button does to cloth.
void showToolGroup(PanelState& state);

/// Keys and mouse, in a window of its own, which the user may close.
void showHelp(bool& shown);

/// What went wrong, in a window of its own. @return whether the scene is to begin anew
bool showTrouble(const std::string& trouble);

}  // namespace drench::demo
