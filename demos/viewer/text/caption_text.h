// Text that is readable on any background, drawn with ImGui.
#pragma once

#include <imgui.h>

#include <string>

namespace drench::viewer {

// Draws a line in white with a dark outline at `size` pixels, wrapped at `width` pixels; 0: not wrapped.
void writeText(ImDrawList& canvas, const std::string& line, ImVec2 at, float size, float width);

// Width and height of a line at `size` pixels, wrapped at `width` pixels; 0: not wrapped.
ImVec2 textSize(const std::string& line, float size, float width);

}  // namespace drench::viewer
