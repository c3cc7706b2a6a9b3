#include "viewer/passes/background_pass.h"

#include "viewer/shaders/shaders.h"

namespace drench::viewer {

BackgroundPass::BackgroundPass()
    : ground_("ground", {shaders::frame, shaders::groundVertex},
              {shaders::frame, shaders::sky, shaders::occlusion, shaders::material, shaders::noise,
               shaders::wetting, shaders::groundFragment}),
      groundDepth_("ground depth", {shaders::frame, shaders::groundVertex}, {shaders::depthFragment}),
      sky_("sky", {shaders::fullScreenVertex},
           {shaders::frame, shaders::sky, shaders::noise, shaders::skyFragment}) {}

void BackgroundPass::draw(bool groundIsSeen) const {
    if (groundIsSeen) drawGround(ground_);
    glBindVertexArray(noAttributes_.name());
    sky_.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void BackgroundPass::drawDepth(bool groundIsSeen) const {
    if (groundIsSeen) drawGround(groundDepth_);
}

void BackgroundPass::drawGround(const ShaderProgram& program) const {
    glBindVertexArray(noAttributes_.name());
    program.use();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace drench::viewer
