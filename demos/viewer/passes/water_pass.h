// Draws the pools of a picture.
#pragma once

#include <vector>

#include "viewer/gl/shader_program.h"
#include "viewer/passes/solids.h"

namespace drench::viewer {

// The pools in graphics memory, and their shader.
class WaterPass {
  public:
    // Needs a current OpenGL context; throws as ShaderProgram does.
    WaterPass();

    // Replaces the waters by those that can be drawn.
    void upload(const std::vector<Water>& waters);
    bool empty() const { return waters_.empty(); }
    // Draws into the bound scene; reads the resolved scene.
    void draw() const;

  private:
    ShaderProgram program_;
    Solids waters_{boxMesh()};
};

}  // namespace drench::viewer
