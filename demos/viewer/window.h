// A window to watch a simulation in.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viewer/picture.h"

namespace drench::viewer {

// The keys a Window reports: space or p pauses, '.' or the right arrow steps (and repeats while held), r
// resets, escape closes, F12 takes a screenshot.
enum class Key { pause, step, reset, close, screenshot };

// A window with an OpenGL 3.3 core context, an ImGui context and a camera that follows the mouse: dragging
// with the left button orbits, with the right or middle button pans, the wheel zooms. Both contexts are
// current from construction on. Main thread only; renderers made in it must go before it does.
class Window {
  public:
    // Size in screen coordinates. Throws std::runtime_error, saying what to do, when there is no display or
    // no OpenGL 3.3.
    Window(int width, int height, const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Whether a window can be opened at all; prints nothing and never throws.
    static bool displayAvailable();

    // False once the user or requestClose() has asked to close it.
    bool isOpen() const;
    // Makes isOpen() false.
    void requestClose();

    // Handles input, moves the camera and starts an ImGui frame, after which ImGui calls may follow.
    void beginFrame();
    // Draws ImGui over framebuffer 0 and shows the result, waiting for the screen.
    void endFrame();

    // The keys pressed between the last two beginFrame calls, in order, without those typed into ImGui.
    const std::vector<Key>& keys() const;
    // The camera that the mouse moves; set it to look elsewhere.
    Camera& camera();
    // Size of framebuffer 0 in pixels; 0 while the window is minimised, which Renderer::draw accepts.
    int framebufferWidth() const;
    // As framebufferWidth.
    int framebufferHeight() const;

  private:
    class Contents;
    std::unique_ptr<Contents> contents_;
};

}  // namespace drench::viewer
