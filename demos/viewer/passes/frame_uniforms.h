// What every shader knows about the frame.
#pragma once

#include <array>

#include "viewer/gl/gl_object.h"
#include "viewer/passes/shadow_fit.h"
#include "viewer/picture/picture.h"

namespace drench::viewer {

// The uniform block Frame of frame.glsl in std140 layout; the two must be changed together.
struct FrameUniforms {
    static constexpr std::size_t maxBalls = 8;

    Eigen::Matrix<float, 4, 4, Eigen::DontAlign> clipFromWorld;
    // To where a place is from the eye.
    Eigen::Matrix<float, 4, 4, Eigen::DontAlign> offsetFromClip;
    Eigen::Matrix<float, 4, 4, Eigen::DontAlign> shadowFromWorld;
    std::array<float, 4> eye;
    // Direction, and the share of its light that passes the clouds.
    std::array<float, 4> towardsSun;
    // Side, texel and depth of the shadow map, metres.
    std::array<float, 4> shadowSize;
    // Ground height, number of balls, and of the open ground the share that is wet and how wet that is.
    std::array<float, 4> ground;
    // Centre and radius of the balls that darken what is near them.
    std::array<std::array<float, 4>, maxBalls> balls;
    // The two elements of the projection that make depth; width that a pixel sees at a distance of 1.
    std::array<float, 4> lens;
    // The rectangle beyond which the ground is open: its least x and z, its largest.
    std::array<float, 4> patched;
};

// The block as the camera sees the picture of width x height pixels, with the picture's drawable
// balls.
FrameUniforms cameraUniforms(const Picture& picture, const std::vector<Ball>& balls, int width, int height,
                             const ShadowFit& shadow);

// The same block with the sun's view in place of the camera's, for drawing the shadow map.
FrameUniforms sunUniforms(const FrameUniforms& camera, const ShadowFit& shadow);

// A FrameUniforms block in graphics memory.
class FrameBlock {
  public:
    // Uploads the values and makes the following draw calls use them.
    void bind(const FrameUniforms& uniforms) const;

  private:
    Buffer buffer_;
};

}  // namespace drench::viewer
