// A sheet in graphics memory.
#pragma once

#include <cstddef>

#include "viewer/gl/gl_object.h"
#include "viewer/passes/sheet_rounding.h"
#include "viewer/passes/sheet_uniforms.h"

namespace drench::viewer {

// The vertices and triangles of one sheet; reused for each frame.
class SheetBuffer {
  public:
    SheetBuffer() {
        glBindVertexArray(vertexArray_.name());
        glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
        attribute(0, 3, offsetof(SheetVertex, position));
        attribute(1, 3, offsetof(SheetVertex, normal));
        attribute(2, 3, offsetof(SheetVertex, albedo));
        attribute(3, 3, offsetof(SheetVertex, gloss));   // with dampness and transmittance
        attribute(4, 2, offsetof(SheetVertex, hollow));  // with the value
        attribute(5, 2, offsetof(SheetVertex, clothCoordinates));
        glBindVertexArray(0);
    }

    // Replaces the sheet.
    void upload(const SheetTriangles& sheet, const SheetUniforms& uniforms) {
        glBindBuffer(GL_UNIFORM_BUFFER, uniforms_.name());
        glBufferData(GL_UNIFORM_BUFFER, sizeof(uniforms), &uniforms, GL_STREAM_DRAW);
        glBindVertexArray(vertexArray_.name());
        glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(sheet.vertices.size() * sizeof(SheetVertex)),
                     sheet.vertices.data(), GL_STREAM_DRAW);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                     static_cast<GLsizeiptr>(sheet.triangles.size() * sizeof(sheet.triangles[0])),
                     sheet.triangles.data(), GL_STREAM_DRAW);
        glBindVertexArray(0);
        indexCount_ = static_cast<GLsizei>(3 * sheet.triangles.size());
    }

    void draw() const {
        glBindBufferBase(GL_UNIFORM_BUFFER, 1, uniforms_.name());
        glBindVertexArray(vertexArray_.name());
        glDrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
    }

  private:
    static void attribute(GLuint location, GLint size, std::size_t offset) {
        glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(SheetVertex),
                              reinterpret_cast<const void*>(offset));
        glEnableVertexAttribArray(location);
    }

    VertexArray vertexArray_;
    Buffer vertices_;
    Buffer indices_;
    Buffer uniforms_;
    GLsizei indexCount_ = 0;
};

}  // namespace drench::viewer
