// Framebuffers for rendering and reading back.
#pragma once

#include "viewer/gl/gl_object.h"
#include "viewer/gl/image.h"

namespace drench::viewer {

// A multisampled picture in linear light, with depth.
class SceneTarget {
  public:
    // Both sides in pixels, 1 or more; throws std::runtime_error when the driver cannot provide it.
    SceneTarget(int width, int height);

    // Makes the following draw calls draw here.
    void bind() const;
    // Averages the samples of each pixel into texture().
    void resolve() const;
    // The same, also for the nearest depth of each pixel, and binds both for shaders: colour to texture unit
    // 1, depth to unit 3. Drawing into this target continues.
    void resolveForLookup() const;
    // The same, with mipmaps of the colour.
    void resolveForBlurredLookup() const;

    GLuint texture() const { return resolvedColour_.name(); }
    int width() const { return width_; }
    int height() const { return height_; }

  private:
    int width_;
    int height_;
    Renderbuffer colour_;
    Renderbuffer depth_;
    Framebuffer framebuffer_;
    Texture resolvedColour_;
    Texture resolvedDepth_;
    Framebuffer resolved_;
};

// A final picture with 8 bits per channel, for reading back.
class ImageTarget {
  public:
    // Both sides in pixels, 1 or more; throws std::runtime_error when the driver cannot provide it.
    ImageTarget(int width, int height);

    GLuint framebuffer() const { return framebuffer_.name(); }
    // Waits for the drawing to finish.
    Image read() const;

  private:
    int width_;
    int height_;
    Renderbuffer colour_;
    Framebuffer framebuffer_;
};

// Shadow map: the depth seen from the sun, and a second texture in which the shaders' output is blended by
// minimum.
class ShadowTarget {
  public:
    // Edge length of the square map in pixels; throws std::runtime_error if the driver cannot provide it.
    explicit ShadowTarget(int resolution);

    // Clears it and makes the following draw calls draw here, blending until they draw elsewhere.
    void begin() const;
    void end() const;
    // Binds the map to texture unit 0 for comparing lookups and to unit 2 for plain ones, and the blended
    // texture to unit 4.
    void bindForLookup() const;
    // Unbinds unit 2 again, because it would interfere with other uses of that unit.
    void unbind() const { glBindSampler(2, 0); }
    int resolution() const { return resolution_; }

  private:
    int resolution_;
    Texture depth_;
    Texture passing_;
    Sampler plain_;
    Framebuffer framebuffer_;
};

// Transmittance of all sheets together towards the camera: for each pixel the product of the output of the
// draw calls, 0 to 1.
class LayersTarget {
  public:
    // Both sides in pixels, 1 or more; throws std::runtime_error when the driver cannot provide it.
    LayersTarget(int width, int height);

    // Sets every pixel to 1 and makes the following draw calls multiply it.
    void begin() const;
    // Ends that, and binds the products to texture unit 5.
    void end() const;

  private:
    int width_;
    int height_;
    Texture product_;
    Framebuffer framebuffer_;
};

}  // namespace drench::viewer
