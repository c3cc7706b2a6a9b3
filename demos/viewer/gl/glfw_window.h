// GLFW and the owner of its windows.
#pragma once

// OpenGL functions come from libepoxy, so GLFW must not include its own.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <memory>
#include <string>

namespace drench::viewer {

// Starts GLFW unless it is running; returns false, without a message, if there is no display. Main thread
// only, as GLFW requires.
bool glfwStarted();

// Owns a GLFW window with an OpenGL 3.3 core context.
class GlfwWindow {
  public:
    enum class Visibility { shown, hidden };

    // Size in screen coordinates. Throws std::runtime_error when there is no display or no OpenGL 3.3.
    GlfwWindow(int width, int height, const std::string& title, Visibility visibility);

    GLFWwindow* handle() const { return window_.get(); }

  private:
    struct Destroy {
        void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
    };

    std::unique_ptr<GLFWwindow, Destroy> window_;
};

}  // namespace drench::viewer
