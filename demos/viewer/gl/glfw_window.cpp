#include "viewer/gl/glfw_window.h"

#include <stdexcept>

namespace drench::viewer {

namespace {

std::string lastError() {
    const char* description = nullptr;
    glfwGetError(&description);
    return description == nullptr ? "unknown reason" : description;
}

}  // namespace

bool glfwStarted() {
    struct StopAtExit {
        StopAtExit() = default;
        ~StopAtExit() { glfwTerminate(); }
        StopAtExit(const StopAtExit&) = delete;
        StopAtExit& operator=(const StopAtExit&) = delete;
    };
    // GLFW stays connected until the program ends, because X servers such as Xvfb restart when their last
    // client disconnects, and refuse connections meanwhile.
    static const StopAtExit stopAtExit;
    return glfwInit() == GLFW_TRUE;
}

GlfwWindow::GlfwWindow(int width, int height, const std::string& title, Visibility visibility) {
    if (!glfwStarted())
        throw std::runtime_error("viewer: no display (" + lastError() + "); run with --headless");
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    // macOS gives 3.3 to forward-compatible contexts only.
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
    // Scaled by the pixel density of the screen.
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, visibility == Visibility::shown ? GLFW_TRUE : GLFW_FALSE);
    // The renderer smooths in a framebuffer of its own and needs no depth here.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    window_.reset(glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr));
    if (!window_) {
        throw std::runtime_error(
            "viewer: OpenGL 3.3 is not available: " + lastError() +
            "; update the graphics driver (Debian: libgl1-mesa-dri) or run with --headless");
    }
}

}  // namespace drench::viewer
