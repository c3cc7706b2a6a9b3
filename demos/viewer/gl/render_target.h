// Framebuffers to draw into and read back.
#pragma once

#include "viewer/gl/gl_object.h"
#include "viewer/gl/image.h"

namespace drench::viewer {

// A smoothed (multisampled) linear-light picture under construction, with depth.
class SceneTarget {
  public:
    // Both sides in pixels, 1 or more; throws std::runtime_error when the driver cannot provide it.
    SceneTarget(int width, int height);

    // Makes the following draw calls draw here.
    void bind() const;
    // Averages the samples of each pixel and leaves the result in texture().
    void resolve() const;
    // The same, and what is nearest in each pixel, and puts both where shaders find them: colour at texture unit 1,
    // depth at unit 3. Drawing goes on in this target.
    void resolveForLookup() const;
    // The same with coarser copies of the colour, each of half the size of the one before.
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

// A finished picture of 8 bits a channel that can be read back.
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

// The depth of the scene seen from the sun, and beside it, blended by the smaller value, what its shaders write.
class ShadowTarget {
  public:
    // Side of the square map in pixels; throws std::runtime_error when the driver cannot provide it.
    explicit ShadowTarget(int resolution);

    // Clears it and makes the following draw calls draw here, blending until they draw elsewhere.
    void begin() const;
    void end() const;
    // Puts the map at texture unit 0 for comparing lookups and at unit 2 for plain ones, and what was blended at unit 4.
    void bindForLookup() const;
    // Takes the plain lookup away again, which would be in the way of other users of unit 2.
    void unbind() const { glBindSampler(2, 0); }
    int resolution() const { return resolution_; }

  private:
    int resolution_;
    Texture depth_;
    Texture passing_;
    Sampler plain_;
    Framebuffer framebuffer_;
};

// How much light all sheets together let through to the eye: for each pixel the product of what its draw calls write, from 0 to 1.
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
