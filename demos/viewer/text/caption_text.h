// Text that is readable on any background, through ImGui.
#pragma once

#include <imgui.h>

#include <string>

namespace drench::viewer {

// Writes a line in white with a dark rim at `size` pixels, wrapped at `width` pixels; 0 never wraps.
void writeText(ImDrawList& canvas, const std::string& line, ImVec2 at, float size, float width);

// Width and height of a line at `size` pixels, wrapped at `width` pixels; 0 never wraps.
ImVec2 textSize(const std::string& line, float size, float width);

}  // namespace drench::viewer
