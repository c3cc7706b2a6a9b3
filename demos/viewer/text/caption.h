// Text and legend of a picture.
#pragma once

#include "viewer/gl/imgui_session.h"
#include "viewer/picture/area.h"
#include "viewer/picture/picture.h"

namespace drench::viewer {

// Draws lines of text at the top or the bottom left of an area, each at most 1/22 of its height, white with a
// dark outline, and the legend at the opposite end, on the right.
class Caption {
  public:
    // Needs a current OpenGL context; throws as ImGuiSession does.
    Caption() = default;

    // Draws the caption and the legend of a picture into an area of the bound framebuffer; leaves the current ImGui
    // context as it was.
    void draw(const Picture& picture, const Area& area);

  private:
    void loadFont(float pixels);

    ImGuiSession session_;
    float fontPixels_ = 0.0f;
};

}  // namespace drench::viewer
