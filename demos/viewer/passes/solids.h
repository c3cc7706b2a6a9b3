// Balls, rods, boxes and standing water in graphics memory.
#pragma once

#include <array>
#include <vector>

#include "viewer/gl/gl_object.h"
#include "viewer/passes/box_mesh.h"
#include "viewer/passes/capsule_mesh.h"
#include "viewer/picture/picture.h"

namespace drench::viewer {

// One ball, rod, box or water as the vertex shaders read it.
struct SolidInstance {
    // A ball's centre and radius, a rod's start and radius, a box's centre, or a water's
    // centre and time.
    std::array<float, 4> first;
    // The orientation (x, y, z, w) of a ball or a box, or a rod's end.
    std::array<float, 4> second;
    // In the last place the number of the material.
    std::array<float, 4> albedo;
    // Half the sides of a box or a water.
    std::array<float, 4> extents = {};
};

// The balls that can be drawn: finite, with a radius above 0.
std::vector<Ball> drawableBalls(const std::vector<Ball>& balls);
// The rods that can be drawn: finite, with a radius above 0.
std::vector<Rod> drawableRods(const std::vector<Rod>& rods);

// The boxes that can be drawn: finite, with a volume above 0.
std::vector<Box> drawableBoxes(const std::vector<Box>& boxes);

// The waters that can be drawn: finite, with a volume above 0.
std::vector<Water> drawableWaters(const std::vector<Water>& waters);

std::vector<SolidInstance> instances(const std::vector<Ball>& balls);
std::vector<SolidInstance> instances(const std::vector<Rod>& rods);
std::vector<SolidInstance> instances(const std::vector<Box>& boxes);
std::vector<SolidInstance> instances(const std::vector<Water>& waters);

// A mesh drawn once for each instance.
class Solids {
  public:
    explicit Solids(const CapsuleMesh& mesh) : Solids(mesh.vertices, mesh.triangles) {}
    explicit Solids(const BoxMesh& mesh) : Solids(mesh.vertices, mesh.triangles) {}
    // Replaces the instances.
    void upload(const std::vector<SolidInstance>& instances);
    void draw() const;
    bool empty() const { return instanceCount_ == 0; }

  private:
    Solids(const std::vector<Eigen::Vector4f>& vertices,
           const std::vector<std::array<std::uint32_t, 3>>& triangles);

    VertexArray vertexArray_;
    Buffer vertices_;
    Buffer indices_;
    Buffer instances_;
    GLsizei indexCount_ = 0;
    GLsizei instanceCount_ = 0;
};

}  // namespace drench::viewer
