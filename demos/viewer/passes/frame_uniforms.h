// Uniforms of a frame for all shaders.
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
    // Clip space to positions relative to the camera.
    Eigen::Matrix<float, 4, 4, Eigen::DontAlign> offsetFromClip;
    Eigen::Matrix<float, 4, 4, Eigen::DontAlign> shadowFromWorld;
    std::array<float, 4> eye;
    // Direction, and fraction of the sunlight that passes the clouds.
    std::array<float, 4> towardsSun;
    // Edge length, texel size and depth range of the shadow map, m.
    std::array<float, 4> shadowSize;
    // Ground height, number of balls, and for the open ground its wet fraction and the wetness of that.
    std::array<float, 4> ground;
    // Centre and radius of the balls for ambient occlusion.
    std::array<std::array<float, 4>, maxBalls> balls;
    // The two elements of the projection that determine depth; width of a pixel at a distance of 1.
    std::array<float, 4> lens;
    // The rectangle beyond which the ground counts as open: smallest x and z, largest x and z.
    std::array<float, 4> patched;
};

// The block for the camera of a picture of width x height pixels, with its drawable balls.
FrameUniforms cameraUniforms(const Picture& picture, const std::vector<Ball>& balls, int width, int height,
                             const ShadowFit& shadow);

// The same block with the view of the sun, for drawing the shadow map.
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
