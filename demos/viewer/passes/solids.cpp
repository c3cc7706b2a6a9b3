#include "viewer/passes/solids.h"

#include <cmath>

#include "viewer/passes/shader_values.h"

namespace drench::viewer {

namespace {

bool hasVolume(const Eigen::Vector3f& half) {
    return isDrawable(half.x()) && isDrawable(half.y()) && isDrawable(half.z());
}

// As numbered in the shaders.
float number(Material material) {
    return static_cast<float>(material);
}

const void* bufferOffset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);
}

}  // namespace

bool isDrawable(const Ball& ball) {
    return isDrawable(ball.centre) && isDrawable(ball.radius) && ball.albedo.allFinite() &&
           ball.orientation.coeffs().allFinite();
}

bool isDrawable(const Rod& rod) {
    return isDrawable(rod.from) && isDrawable(rod.to) && isDrawable(rod.radius) && rod.albedo.allFinite();
}

bool isDrawable(const Box& box) {
    return isDrawable(box.centre) && hasVolume(box.halfExtents) && box.albedo.allFinite() &&
           box.orientation.coeffs().allFinite();
}

bool isDrawable(const Water& water) {
    return isDrawable(water.centre) && hasVolume(water.halfExtents) && std::isfinite(water.time);
}

SolidInstance instanceOf(const Ball& ball) {
    return {packed(ball.centre, ball.radius), packed(ball.orientation),
            packed(ball.albedo, number(ball.material))};
}

SolidInstance instanceOf(const Rod& rod) {
    return {packed(rod.from, rod.radius), packed(rod.to, 1.0f), packed(rod.albedo, number(rod.material))};
}

SolidInstance instanceOf(const Box& box) {
    return {packed(box.centre, 1.0f), packed(box.orientation), packed(box.albedo, number(box.material)),
            packed(box.halfExtents, 0.0f)};
}

SolidInstance instanceOf(const Water& water) {
    return {packed(water.centre, water.time), {}, {}, packed(water.halfExtents, 0.0f)};
}

Solids::Solids(const SolidMesh& mesh) : indexCount_(static_cast<GLsizei>(3 * mesh.triangles.size())) {
    const auto& [vertices, triangles] = mesh;
    glBindVertexArray(vertexArray_.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(vertices[0])),
                 vertices.data(), GL_STATIC_DRAW);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(vertices[0]), nullptr);
    glEnableVertexAttribArray(0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size() * sizeof(triangles[0])),
                 triangles.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
    for (GLuint i = 0; i < 4; ++i) {
        glVertexAttribPointer(1 + i, 4, GL_FLOAT, GL_FALSE, sizeof(SolidInstance),
                              bufferOffset(i * sizeof(std::array<float, 4>)));
        glVertexAttribDivisor(1 + i, 1);
        glEnableVertexAttribArray(1 + i);
    }
    glBindVertexArray(0);
}

void Solids::uploadInstances(const std::vector<SolidInstance>& instances) {
    instanceCount_ = static_cast<GLsizei>(instances.size());
    glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size() * sizeof(SolidInstance)),
                 instances.data(), GL_STREAM_DRAW);
}

void Solids::draw() const {
    if (instanceCount_ > 0) {
        glBindVertexArray(vertexArray_.name());
        glDrawElementsInstanced(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr, instanceCount_);
    }
}

}  // namespace drench::viewer
