#include "viewer/passes/solids.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace drench::viewer {

namespace {

constexpr float farthest = 1e5f;

bool drawable(const Eigen::Vector3f& point) {
    return point.allFinite() && point.cwiseAbs().maxCoeff() <= farthest;
}

bool drawable(float radius) {
    return radius > 0.0f && radius <= farthest;
}

std::array<float, 4> packed(const Eigen::Vector3f& vector, float last) {
    return {vector.x(), vector.y(), vector.z(), last};
}

std::array<float, 4> packed(const Eigen::Quaternionf& turn) {
    return {turn.x(), turn.y(), turn.z(), turn.w()};
}

// As the shaders know it.
float number(Material material) {
    return static_cast<float>(material);
}

const void* bufferOffset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);
}

}  // namespace

std::vector<Ball> drawableBalls(const std::vector<Ball>& balls) {
    std::vector<Ball> kept;
    std::copy_if(balls.begin(), balls.end(), std::back_inserter(kept), [](const Ball& ball) {
        return drawable(ball.centre) && drawable(ball.radius) && ball.albedo.allFinite() &&
               ball.orientation.coeffs().allFinite();
    });
    return kept;
}

std::vector<Rod> drawableRods(const std::vector<Rod>& rods) {
    std::vector<Rod> kept;
    std::copy_if(rods.begin(), rods.end(), std::back_inserter(kept), [](const Rod& rod) {
        return drawable(rod.from) && drawable(rod.to) && drawable(rod.radius) && rod.albedo.allFinite();
    });
    return kept;
}

std::vector<Box> drawableBoxes(const std::vector<Box>& boxes) {
    std::vector<Box> kept;
    std::copy_if(boxes.begin(), boxes.end(), std::back_inserter(kept), [](const Box& box) {
        const Eigen::Vector3f& half = box.halfExtents;
        return drawable(box.centre) && drawable(half.x()) && drawable(half.y()) && drawable(half.z()) &&
               box.albedo.allFinite() && box.orientation.coeffs().allFinite();
    });
    return kept;
}

std::vector<Water> drawableWaters(const std::vector<Water>& waters) {
    std::vector<Water> kept;
    std::copy_if(waters.begin(), waters.end(), std::back_inserter(kept), [](const Water& water) {
        const Eigen::Vector3f& half = water.halfExtents;
        return drawable(water.centre) && drawable(half.x()) && drawable(half.y()) && drawable(half.z()) &&
               std::isfinite(water.time);
    });
    return kept;
}

std::vector<SolidInstance> instances(const std::vector<Ball>& balls) {
    std::vector<SolidInstance> packedBalls;
    packedBalls.reserve(balls.size());
    for (const Ball& ball : balls) {
        packedBalls.push_back({packed(ball.centre, ball.radius), packed(ball.orientation),
                               packed(ball.albedo, number(ball.material))});
    }
    return packedBalls;
}

std::vector<SolidInstance> instances(const std::vector<Rod>& rods) {
    std::vector<SolidInstance> packedRods;
    packedRods.reserve(rods.size());
    for (const Rod& rod : rods) {
        packedRods.push_back(
            {packed(rod.from, rod.radius), packed(rod.to, 1.0f), packed(rod.albedo, number(rod.material))});
    }
    return packedRods;
}

std::vector<SolidInstance> instances(const std::vector<Box>& boxes) {
    std::vector<SolidInstance> packedBoxes;
    packedBoxes.reserve(boxes.size());
    for (const Box& box : boxes) {
        packedBoxes.push_back({packed(box.centre, 1.0f), packed(box.orientation),
                               packed(box.albedo, number(box.material)), packed(box.halfExtents, 0.0f)});
    }
    return packedBoxes;
}

std::vector<SolidInstance> instances(const std::vector<Water>& waters) {
    std::vector<SolidInstance> packedWaters;
    packedWaters.reserve(waters.size());
    for (const Water& water : waters) {
        packedWaters.push_back({packed(water.centre, water.time), {}, {}, packed(water.halfExtents, 0.0f)});
    }
    return packedWaters;
}

Solids::Solids(const std::vector<Eigen::Vector4f>& vertices,
               const std::vector<std::array<std::uint32_t, 3>>& triangles)
    : indexCount_(static_cast<GLsizei>(3 * triangles.size())) {
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

void Solids::upload(const std::vector<SolidInstance>& instances) {
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
