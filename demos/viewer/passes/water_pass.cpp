#include "viewer/passes/water_pass.h"

#include "viewer/shaders/shaders.h"

namespace drench::viewer {

WaterPass::WaterPass()
    : program_("water", {shaders::frame, shaders::waterVertex},
               {shaders::frame, shaders::sky, shaders::occlusion, shaders::material, shaders::noise,
                shaders::placeBehind, shaders::waterFragment}) {}

void WaterPass::upload(const std::vector<Water>& waters) {
    waters_.upload(drawable(waters));
}

void WaterPass::draw() const {
    program_.use();
    waters_.draw();
}

}  // namespace drench::viewer
