// Draws drops, streaks and mist.
#pragma once

#include "viewer/gl/instanced_quads.h"
#include "viewer/gl/shader_program.h"
#include "viewer/picture/picture.h"

namespace drench::viewer {

// Water in the air, blended over the finished scene.
class AirborneWater {
  public:
    // Throws std::runtime_error when the driver refuses a shader.
    AirborneWater();

    // Replaces the contents, without objects that are not finite or have no size.
    void upload(const Picture& picture);
    bool empty() const { return drops_.empty() && streaks_.empty() && puffs_.empty(); }
    // Draws all into the current framebuffer. The frame's uniforms, the shadow map and the colour and the
    // depth of the scene must be bound.
    void draw() const;

  private:
    ShaderProgram dropProgram_;
    ShaderProgram streakProgram_;
    ShaderProgram puffProgram_;
    InstancedQuads<2> drops_;
    InstancedQuads<2> streaks_;
    InstancedQuads<2> puffs_;
};

}  // namespace drench::viewer
