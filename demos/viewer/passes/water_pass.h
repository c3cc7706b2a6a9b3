// Draws the standing water of a picture.
#pragma once

#include <vector>

#include "viewer/gl/shader_program.h"
#include "viewer/passes/solids.h"

namespace drench::viewer {

// The waters in graphics memory and the shader that draws them.
class WaterPass {
  public:
    // Needs a current OpenGL context; throws as ShaderProgram does.
    WaterPass();

    // Replaces the waters by those that can be drawn.
    void upload(const std::vector<Water>& waters);
    bool empty() const { return waters_.empty(); }
    // Draws into the bound scene over what is resolved for lookup.
    void draw() const;

  private:
    ShaderProgram program_;
    Solids waters_{boxMesh()};
};

}  // namespace drench::viewer
