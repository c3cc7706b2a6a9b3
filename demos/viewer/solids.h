// Balls and rods in graphics memory.
#pragma once

#include <array>
#include <vector>

#include "viewer/capsule_mesh.h"
#include "viewer/gl_object.h"
#include "viewer/picture.h"

namespace drench::viewer {

// One ball or rod as the vertex shaders read it.
struct SolidInstance {
    // A ball's centre and radius, or a rod's start and radius.
    std::array<float, 4> first;
    // A ball's orientation (x, y, z, w), or a rod's end.
    std::array<float, 4> second;
    std::array<float, 4> albedo;
};

// The balls that can be drawn: finite, with a radius above 0.
std::vector<Ball> drawableBalls(const std::vector<Ball>& balls);
// The rods that can be drawn: finite, with a radius above 0.
std::vector<Rod> drawableRods(const std::vector<Rod>& rods);

std::vector<SolidInstance> instances(const std::vector<Ball>& balls);
std::vector<SolidInstance> instances(const std::vector<Rod>& rods);

// A capsule mesh drawn once for each instance.
class Solids {
  public:
    explicit Solids(const CapsuleMesh& mesh);
    // Replaces the instances.
    void upload(const std::vector<SolidInstance>& instances);
    void draw() const;

  private:
    VertexArray vertexArray_;
    Buffer vertices_;
    Buffer indices_;
    Buffer instances_;
    GLsizei indexCount_ = 0;
    GLsizei instanceCount_ = 0;
};

}  // namespace drench::viewer
