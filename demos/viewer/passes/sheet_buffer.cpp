#include "viewer/passes/sheet_buffer.h"

#include <cstddef>

namespace drench::viewer {

namespace {

// Texels of four numbers in a node.
constexpr std::size_t nodeTexels = sizeof(SheetVertex) / (4 * sizeof(float));

std::size_t maxNodes() {
    GLint texels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    return static_cast<std::size_t>(texels) / nodeTexels;
}

template <typename Value>
void fill(GLenum target, const Buffer& buffer, const std::vector<Value>& values, GLenum usage) {
    glBindBuffer(target, buffer.name());
    glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(Value)), values.data(), usage);
}

const void* at(std::size_t offset) {
    return reinterpret_cast<const void*>(offset);
}

void vertexAttribute(GLuint location, GLint size, std::size_t offset) {
    glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(SheetVertex), at(offset));
    glEnableVertexAttribArray(location);
}

}  // namespace

SheetBuffer::SheetBuffer() : division_(maxNodes()) {
    glBindVertexArray(cornerArray_.name());
    glBindBuffer(GL_ARRAY_BUFFER, corners_.name());
    glVertexAttribIPointer(0, 3, GL_UNSIGNED_INT, sizeof(DividedVertex),
                           at(offsetof(DividedVertex, corners)));
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(DividedVertex),
                          at(offsetof(DividedVertex, weights)));
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);

    glBindVertexArray(vertexArray_.name());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    vertexAttribute(0, 3, offsetof(SheetVertex, position));
    vertexAttribute(1, 4, offsetof(SheetVertex, normal));  // with the hollow
    vertexAttribute(2, 4, offsetof(SheetVertex, albedo));  // with the value
    vertexAttribute(3, 2, offsetof(SheetVertex, clothCoordinates));
    vertexAttribute(4, 3, offsetof(SheetVertex, gloss));  // with dampness and transmittance
    glBindVertexArray(0);

    glBindBuffer(GL_TEXTURE_BUFFER, nodes_.name());
    glBindTexture(GL_TEXTURE_BUFFER, nodeTexture_.name());
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, nodes_.name());
}

void SheetBuffer::upload(const std::vector<SheetVertex>& nodes, const std::vector<Triangle>& triangles,
                         const SheetUniforms& uniforms) {
    glBindBuffer(GL_UNIFORM_BUFFER, uniforms_.name());
    glBufferData(GL_UNIFORM_BUFFER, sizeof(uniforms), &uniforms, GL_STREAM_DRAW);
    if (const auto changed = division_.update(nodes.size(), triangles)) replaceTriangles(*changed);
    if (dividedCount_ > 0)
        fill(GL_TEXTURE_BUFFER, nodes_, nodes, GL_STREAM_DRAW);
    else
        fill(GL_ARRAY_BUFFER, vertices_, nodes, GL_STREAM_DRAW);
}

void SheetBuffer::replaceTriangles(const DividedSheet& sheet) {
    fill(GL_ARRAY_BUFFER, corners_, sheet.vertices, GL_STATIC_DRAW);
    glBindVertexArray(vertexArray_.name());
    fill(GL_ELEMENT_ARRAY_BUFFER, indices_, sheet.triangles, GL_STATIC_DRAW);
    glBindVertexArray(0);
    dividedCount_ = static_cast<GLsizei>(sheet.vertices.size());
    indexCount_ = static_cast<GLsizei>(3 * sheet.triangles.size());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(sheet.vertices.size() * sizeof(SheetVertex)),
                 nullptr, GL_DYNAMIC_COPY);
}

void SheetBuffer::round(const ShaderProgram& rounding) const {
    if (dividedCount_ == 0) return;
    rounding.use();
    glActiveTexture(GL_TEXTURE7);
    glBindTexture(GL_TEXTURE_BUFFER, nodeTexture_.name());
    glActiveTexture(GL_TEXTURE0);
    glBindVertexArray(cornerArray_.name());
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, vertices_.name());
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, dividedCount_);
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
}

void SheetBuffer::draw() const {
    glBindBufferBase(GL_UNIFORM_BUFFER, 1, uniforms_.name());
    glBindVertexArray(vertexArray_.name());
    glDrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace drench::viewer
