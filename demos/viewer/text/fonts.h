// Fonts for ImGui.
#pragma once

#include <imgui.h>

namespace drench::viewer {

// Adds the system's plain font at a height in pixels, with Latin, Greek and mathematical characters; or
// ImGui's own small font if no known font is installed.
void addReadableFont(ImFontAtlas& fonts, float pixels);

}  // namespace drench::viewer
