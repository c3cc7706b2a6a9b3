// What the user has chosen in the window.
#pragma once

#include <optional>
#include <string>

#include "description/scene_description.h"
#include "hand/pointer.h"
#include "stage/pictures.h"
#include "scenes/registry.h"
#include "stage/scene.h"

namespace drench::demo {

/// Stays as it is when the window is resized, minimised or left, and when a scene begins anew.
struct PanelState {
    std::string scene;          ///< a name of `scenes()`
    SceneOptions options;       ///< for the next scene that is made
    bool fabricChosen = false;  ///< by the user, rather than by the scene
    Weather weather;            ///< as it is, or as sliders under the mouse have it
    double waterSpeed = 1;      ///< the same
    int wetting = -1;           ///< the step of wetting chosen last, tenths; -1: none
    Tool tool = Tool::hand;
    View view = View::beauty;
    bool split = false;                         ///< dry and wet side by side
    std::optional<SceneDescription> described;  ///< a scene from a file; none: one of `scenes()`
    std::string file = "scene.json";            ///< to save to and load from
    bool shown = true;
    bool helpShown = false;
    std::string notice;  ///< to be seen beside the readings; empty: none
};

/// Chooses a scene, with the fabric that suits it unless the user has chosen one.
void chooseScene(PanelState& state, const SceneEntry& entry);

}  // namespace drench::demo
