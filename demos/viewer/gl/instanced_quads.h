// Draws many small quads at once.
#pragma once

#include <array>
#include <vector>

#include "viewer/gl/gl_object.h"

namespace drench::viewer {

// A list of instances of `Size` vectors each. A vertex shader reads them at the locations 0, 1, ... and makes
// a quad of each, corner by corner from gl_VertexID.
template <std::size_t Size>
class InstancedQuads {
  public:
    using Instance = std::array<std::array<float, 4>, Size>;

    InstancedQuads() {
        glBindVertexArray(vertexArray_.name());
        glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
        for (GLuint i = 0; i < Size; ++i) {
            const std::size_t offset = i * sizeof(std::array<float, 4>);
            glVertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, sizeof(Instance),
                                  reinterpret_cast<const void*>(offset));
            glVertexAttribDivisor(i, 1);
            glEnableVertexAttribArray(i);
        }
        glBindVertexArray(0);
    }

    // Replaces the instances.
    void upload(const std::vector<Instance>& instances) {
        count_ = static_cast<GLsizei>(instances.size());
        glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size() * sizeof(Instance)),
                     instances.data(), GL_STREAM_DRAW);
    }
    void draw() const {
        if (count_ > 0) {
            glBindVertexArray(vertexArray_.name());
            glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
        }
    }
    bool empty() const { return count_ == 0; }

  private:
    VertexArray vertexArray_;
    Buffer instances_;
    GLsizei count_ = 0;
};

}  // namespace drench::viewer
