// How much light all sheets together let through to the eye.
#pragma once

#include "viewer/gl/gl_object.h"

namespace drench::viewer {

// For each pixel the product of what its draw calls write, from 0 to 1.
class LayersTarget {
  public:
    // Both sides in pixels, 1 or more; throws std::runtime_error when the driver cannot provide it.
    LayersTarget(int width, int height);

    // Sets every pixel to 1 and makes the following draw calls multiply it.
    void begin() const;
    // Ends that, and puts the products at texture unit 5.
    void end() const;

  private:
    int width_;
    int height_;
    Texture product_;
    Framebuffer framebuffer_;
};

}  // namespace drench::viewer
