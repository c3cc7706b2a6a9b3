// Draws pictures with OpenGL 3.3.
#pragma once

#include <memory>

#include "viewer/gl/image.h"
#include "viewer/picture/area.h"
#include "viewer/picture/picture.h"

namespace drench::viewer {

// Draws into the OpenGL context that was current when it was made; that context must be current in every call
// and must outlive the renderer.
class Renderer {
  public:
    // Throws std::runtime_error when no context is current, when its OpenGL is older than 3.3 or when the
    // driver refuses a shader.
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Draws the picture over the whole of `framebuffer` (0: the window), which is width x height pixels; does
    // nothing when either is below 1. Leaves the framebuffer bound. Throws std::runtime_error on a camera, a
    // sun or a sheet that picture.h does not allow, or a size that the driver cannot provide.
    void draw(const Picture& picture, int width, int height, unsigned framebuffer = 0);

    // The same in a part of the framebuffer; the size of text and legend is adapted to it.
    void draw(const Picture& picture, const Area& area, unsigned framebuffer = 0);

    // Draws two pictures side by side, with a thin line between them, over the whole of `framebuffer`; otherwise as
    // above.
    void drawPair(const Picture& left, const Picture& right, int width, int height, unsigned framebuffer = 0);

    // Renders the picture off screen and returns it; throws as draw does, and also on a size below 1 x 1.
    Image capture(const Picture& picture, int width, int height);

    // The same with two pictures side by side.
    Image capturePair(const Picture& left, const Picture& right, int width, int height);

    // OpenGL errors since construction; 0 if there are none.
    int glErrors() const;

  private:
    class Passes;
    std::unique_ptr<Passes> passes_;
};

}  // namespace drench::viewer
