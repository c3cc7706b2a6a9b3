// Balls, capsules, boxes and pools in graphics memory.
#pragma once

#include <array>
#include <vector>

#include "viewer/gl/gl_object.h"
#include "viewer/passes/solid_meshes.h"
#include "viewer/picture/picture.h"

namespace drench::viewer {

// One ball, capsule, box or pool as the vertex shaders read it.
struct SolidInstance {
    // A ball's centre and radius, a rod's start and radius, a box's centre, or a water's
    // centre and time.
    std::array<float, 4> first;
    // The orientation (x, y, z, w) of a ball or a box, or a rod's end.
    std::array<float, 4> second;
    // The last component is the number of the material.
    std::array<float, 4> albedo;
    // Half the edge lengths of a box or a pool.
    std::array<float, 4> extents = {};
};

// Whether it can be drawn: finite, with a radius or a volume above 0.
bool isDrawable(const Ball& ball);
bool isDrawable(const Rod& rod);
bool isDrawable(const Box& box);
bool isDrawable(const Water& water);

SolidInstance instanceOf(const Ball& ball);
SolidInstance instanceOf(const Rod& rod);
SolidInstance instanceOf(const Box& box);
SolidInstance instanceOf(const Water& water);

// The drawable ones.
template <typename Solid>
std::vector<Solid> drawable(const std::vector<Solid>& solids) {
    std::vector<Solid> kept;
    for (const Solid& solid : solids)
        if (isDrawable(solid)) kept.push_back(solid);
    return kept;
}

// A mesh drawn once for each instance.
class Solids {
  public:
    explicit Solids(const SolidMesh& mesh);
    // Replaces the instances, all of which must be drawable.
    template <typename Solid>
    void upload(const std::vector<Solid>& solids) {
        std::vector<SolidInstance> instances;
        for (const Solid& solid : solids) instances.push_back(instanceOf(solid));
        uploadInstances(instances);
    }
    void draw() const;
    bool empty() const { return instanceCount_ == 0; }

  private:
    void uploadInstances(const std::vector<SolidInstance>& instances);

    VertexArray vertexArray_;
    Buffer vertices_;
    Buffer indices_;
    Buffer instances_;
    GLsizei indexCount_ = 0;
    GLsizei instanceCount_ = 0;
};

}  // namespace drench::viewer
