// Text over a picture.
#pragma once

#include <string>
#include <vector>

#include "viewer/imgui_session.h"

namespace drench::viewer {

// Writes lines of text at the top or the bottom left of a framebuffer, about 1/22 of its height each, white with a dark
// rim.
class Caption {
  public:
    // Needs a current OpenGL context; throws as ImGuiSession does.
    Caption() = default;

    // Draws into the bound framebuffer of width x height pixels; leaves the current ImGui context as it was.
    void draw(const std::vector<std::string>& lines, int width, int height, bool below);

  private:
    void loadFont(float pixels);

    ImGuiSession session_;
    float fontPixels_ = 0.0f;
};

}  // namespace drench::viewer
