#include "viewer/passes/frame_uniforms.h"

#include <Eigen/LU>
#include <algorithm>

#include "viewer/passes/shader_values.h"

namespace drench::viewer {

namespace {

void addBalls(FrameUniforms& uniforms, const std::vector<Ball>& balls) {
    const std::size_t count = std::min(balls.size(), FrameUniforms::maxBalls);
    for (std::size_t i = 0; i < count; ++i) uniforms.balls[i] = packed(balls[i].centre, balls[i].radius);
    uniforms.ground[1] = static_cast<float>(count);
}

void addOpenGround(FrameUniforms& uniforms, const OpenGround& open) {
    uniforms.ground[2] = std::clamp(open.covered, 0.0f, 1.0f);
    uniforms.ground[3] = std::clamp(open.wetness, 0.0f, 1.0f);
    uniforms.patched = {open.from.x(), open.from.y(), open.to.x(), open.to.y()};
}

}  // namespace

FrameUniforms cameraUniforms(const Picture& picture, const std::vector<Ball>& balls, int width, int height,
                             const ShadowFit& shadow) {
    FrameUniforms uniforms{};
    const auto rows = static_cast<float>(height);
    const Eigen::Matrix4f projection = picture.camera.projection(static_cast<float>(width) / rows);
    const Eigen::Matrix4f clipFromWorld = projection * picture.camera.view();
    uniforms.clipFromWorld = clipFromWorld;
    // Relative to the camera, so that rays are accurate however far the far plane is.
    Eigen::Matrix4f turned = picture.camera.view();
    turned.topRightCorner<3, 1>().setZero();
    uniforms.offsetFromClip = (projection * turned).inverse();
    uniforms.shadowFromWorld = shadow.clipFromWorld;
    uniforms.eye = packed(picture.camera.eye(), 1.0f);
    uniforms.towardsSun = packed(picture.towardsSun.normalized(), picture.sunshine);
    uniforms.shadowSize = {shadow.side, shadow.texel, shadow.depth, 0.0f};
    uniforms.ground[0] = picture.groundHeight;
    addBalls(uniforms, balls);
    addOpenGround(uniforms, picture.openGround);
    uniforms.lens = {projection(2, 2), projection(2, 3), 2.0f / (projection(1, 1) * rows), 0.0f};
    return uniforms;
}

FrameUniforms sunUniforms(const FrameUniforms& camera, const ShadowFit& shadow) {
    FrameUniforms uniforms = camera;
    uniforms.clipFromWorld = shadow.clipFromWorld;
    return uniforms;
}

void FrameBlock::bind(const FrameUniforms& uniforms) const {
    glBindBuffer(GL_UNIFORM_BUFFER, buffer_.name());
    glBufferData(GL_UNIFORM_BUFFER, sizeof(uniforms), &uniforms, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, buffer_.name());
}

}  // namespace drench::viewer
