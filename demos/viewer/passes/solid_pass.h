// Draws the balls, capsules and boxes of a picture.
#pragma once

#include <vector>

#include "viewer/gl/shader_program.h"
#include "viewer/passes/solids.h"

namespace drench::viewer {

// The solids in graphics memory, and their shaders.
class SolidPass {
  public:
    // Needs a current OpenGL context; throws as ShaderProgram does.
    SolidPass();

    // Replaces the solids by those of the picture that can be drawn, and adds points that surround each of them to
    // `casters`.
    void upload(const Picture& picture, std::vector<Eigen::Vector3f>& casters);
    // Draws into the bound shadow map.
    void drawShadows() const;
    // Draws into a bound target that has depth only.
    void drawDepth() const { drawShadows(); }
    // Draws into the bound scene.
    void draw() const;

  private:
    struct Programs {
        ShaderProgram ball, rod, box;
    };
    void draw(const Programs& programs) const;

    Programs programs_;
    Programs shadowPrograms_;
    Solids balls_{capsuleMesh(96, 24)};
    Solids rods_{capsuleMesh(20, 5)};
    Solids boxes_{boxMesh()};
};

}  // namespace drench::viewer
