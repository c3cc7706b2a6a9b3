// Draws the sheets of a picture.
#pragma once

#include <vector>

#include "viewer/gl/shader_program.h"
#include "viewer/passes/sheet_buffer.h"

namespace drench::viewer {

// The sheets in graphics memory, and their shaders.
class SheetPass {
  public:
    // Needs a current OpenGL context; throws as ShaderProgram does.
    SheetPass();

    // Replaces the sheets by those of the picture, and adds the positions of those that can be drawn to
    // `casters`. Throws as sheetSurface does.
    void upload(const Picture& picture, std::vector<Eigen::Vector3f>& casters);
    bool empty() const { return count_ == 0; }
    // Computes what is drawn, after each upload. Draws nothing, but OpenGL wants a complete framebuffer bound.
    void round() const;
    // Draws into the bound shadow map.
    void drawShadows() const;
    // Draws the transmittance of each sheet into the bound layers, where no solid in the resolved scene hides
    // it.
    void drawLayers() const;
    // Draws into the bound scene; reads the resolved scene.
    void draw() const;

  private:
    void drawAll() const;

    ShaderProgram roundingProgram_;
    ShaderProgram program_;
    ShaderProgram shadowProgram_;
    ShaderProgram layerProgram_;
    std::vector<SheetBuffer> sheets_;
    std::size_t count_ = 0;
};

}  // namespace drench::viewer
