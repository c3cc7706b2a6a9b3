// Draws the ground and the sky.
#pragma once

#include "viewer/gl/shader_program.h"

namespace drench::viewer {

// The ground and the sky.
class BackgroundPass {
  public:
    // Needs a current OpenGL context; throws as ShaderProgram does.
    BackgroundPass();

    // Draws into the bound scene, where no nearer object is drawn already.
    void draw(bool groundIsSeen) const;
    // Draws the ground into a bound target that has depth only.
    void drawDepth(bool groundIsSeen) const;

  private:
    void drawGround(const ShaderProgram& program) const;

    VertexArray noAttributes_;
    ShaderProgram ground_;
    ShaderProgram groundDepth_;
    ShaderProgram sky_;
};

}  // namespace drench::viewer
