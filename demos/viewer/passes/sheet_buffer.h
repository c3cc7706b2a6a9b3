// A sheet in graphics memory.
#pragma once

#include "viewer/gl/gl_object.h"
#include "viewer/gl/shader_program.h"
#include "viewer/passes/sheet_division.h"
#include "viewer/passes/sheet_surface.h"
#include "viewer/passes/sheet_uniforms.h"

namespace drench::viewer {

// The vertices and triangles of one sheet. Each frame brings its nodes; the graphics card bends divided triangles
// to follow the normals at their corners, so that cloth on a ball looks round and the ball does not show through
// flat facets. The nodes themselves do not move.
class SheetBuffer {
  public:
    // Needs a current OpenGL context.
    SheetBuffer();

    // Replaces the nodes, and the triangles if they are others than before.
    void upload(const std::vector<SheetVertex>& nodes, const std::vector<Triangle>& triangles,
                const SheetUniforms& uniforms);
    // Computes the vertices with the program of sheetRounding.glsl, after each upload and before drawing.
    void round(const ShaderProgram& rounding) const;
    void draw() const;

  private:
    void replaceTriangles(const DividedSheet& sheet);

    SheetDivision division_;
    // Constant until the triangles change.
    Buffer corners_;
    Buffer indices_;
    GLsizei dividedCount_ = 0;
    GLsizei indexCount_ = 0;
    // Nodes of divided sheets, and the texture through which the rounding reads them.
    Buffer nodes_;
    Texture nodeTexture_;
    Buffer vertices_;
    Buffer uniforms_;
    VertexArray cornerArray_;
    VertexArray vertexArray_;
};

}  // namespace drench::viewer
