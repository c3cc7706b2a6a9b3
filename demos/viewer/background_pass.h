// Draws the ground and the sky.
#pragma once

#include "viewer/shader_program.h"

namespace drench::viewer {

// What lies behind everything else.
class BackgroundPass {
  public:
    // Needs a current OpenGL context; throws as ShaderProgram does.
    BackgroundPass();

    // Draws into the bound scene, where nothing nearer is drawn already.
    void draw(bool groundIsSeen) const;

  private:
    VertexArray noAttributes_;
    ShaderProgram ground_;
    ShaderProgram sky_;
};

}  // namespace drench::viewer
