#include "viewer/background_pass.h"

#include "viewer/shaders_background.h"
#include "viewer/shaders_lighting.h"
#include "viewer/shaders_noise.h"

namespace drench::viewer {

BackgroundPass::BackgroundPass()
    : ground_("ground", {shaders::frame, shaders::groundVertex},
              {shaders::frame, shaders::sky, shaders::occlusion, shaders::noise, shaders::groundFragment}),
      sky_("sky", {shaders::fullScreenVertex},
           {shaders::frame, shaders::sky, shaders::noise, shaders::skyFragment}) {}

void BackgroundPass::draw(bool groundIsSeen) const {
    glBindVertexArray(noAttributes_.name());
    if (groundIsSeen) {
        ground_.use();
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
    sky_.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace drench::viewer
