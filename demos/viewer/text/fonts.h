// Letters for ImGui.
#pragma once

#include <imgui.h>

namespace drench::viewer {

// Adds the system's plain font at a height in pixels, with Latin, Greek and mathematical signs; where there
// is none of those that are known, ImGui's own small one.
void addReadableFont(ImFontAtlas& fonts, float pixels);

}  // namespace drench::viewer
