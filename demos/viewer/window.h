// A window for watching a simulation.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/picture/picking.h"
#include "viewer/picture/picture.h"

namespace drench::viewer {

// The keys that a Window reports when they are pressed.
enum class Key {
    pause,        // space or p
    step,         // '.' or right arrow; repeats while held
    reset,        // r
    wetter,       // up arrow
    drier,        // down arrow
    nextScene,    // page down
    formerScene,  // page up
    nextView,     // v
    split,        // s
    panel,        // tab
    help,         // F1
    record,       // F9
    screenshot,   // F12
    close         // escape
};

// Keys whose held state is read.
enum class HeldKey { h, d };

// The mouse over the picture, not over ImGui's windows.
struct Mouse {
    Ray ray;
    // Index of the picture under it, from the left, of several side by side.
    int column = 0;
    // The left button: held, and whether it was pressed in this frame.
    bool left = false;
    bool leftWentDown = false;
};

// A window with an OpenGL 3.3 core context, an ImGui context and a camera that the mouse moves. Both contexts
// are current from construction on. Main thread only; renderers made in it must be destroyed before it.
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

    // Handles input and starts an ImGui frame, after which ImGui calls may follow.
    void beginFrame();
    // Moves the camera by the mouse input of this frame: the right or middle button pans, the wheel zooms,
    // and the left button orbits if it is free. Buttons pressed over ImGui's windows are ignored.
    void moveCamera(bool leftOrbits);
    // Draws ImGui over framebuffer 0 and shows the result, waiting for the screen.
    void endFrame();

    // The keys pressed between the last two beginFrame calls, in order, except those typed into ImGui.
    const std::vector<Key>& keys() const;
    // Whether a key is held now; false while the window does not have the focus or text is being typed.
    bool isHeld(HeldKey key) const;
    // Position of the mouse over one of `columns` pictures of equal width side by side; none while it is
    // over ImGui's windows or the window does not have the focus. While a button is held, it stays assigned
    // to the pictures wherever the mouse moves.
    std::optional<Mouse> mouse(int columns = 1) const;
    // Name of the OpenGL driver.
    std::string rendererName() const;
    // The camera that the mouse moves; may be set.
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
