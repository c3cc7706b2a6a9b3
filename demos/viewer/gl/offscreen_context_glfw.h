// Part of offscreen_context.cpp for systems without EGL.
#pragma once

#include "viewer/gl/glfw_window.h"
#include "viewer/gl/offscreen_context.h"

namespace drench::viewer {

class OffscreenContext::Platform {
  public:
    Platform() : window_(64, 64, "off screen", GlfwWindow::Visibility::hidden) { makeCurrent(); }

    void makeCurrent() const { glfwMakeContextCurrent(window_.handle()); }

  private:
    GlfwWindow window_;
};

}  // namespace drench::viewer
