// OpenGL without a window.
#pragma once

#include <memory>

namespace drench::viewer {

// An OpenGL 3.3 core context that needs no display: surfaceless EGL on Linux, a hidden GLFW window elsewhere.
// It has no framebuffer of its own; draw with Renderer::capture.
class OffscreenContext {
  public:
    // Creates the context and makes it current on this thread; throws std::runtime_error that says what to
    // install if there is no usable OpenGL.
    OffscreenContext();
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    // Makes it current on this thread again, after another context was current.
    void makeCurrent() const;

  private:
    class Platform;
    std::unique_ptr<Platform> platform_;
};

}  // namespace drench::viewer
