// The panel over the picture: what to watch and what to change.
#pragma once

#include <string>

#include "scene.h"

namespace drench::demo {

/// What the user asked for in the panel during one frame.
struct PanelWishes {
    bool togglePause = false;
    bool step = false;
    bool restart = false;  ///< with the fabric as it stands in the options now
};

/// Shows the panel within an ImGui frame.
/// @param options  the scene's; the fabric may be changed
PanelWishes showPanel(Scene& scene, SceneOptions& options, bool paused);

}  // namespace drench::demo
