// The shape that boxes are drawn with; plain arithmetic, no OpenGL.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace drench::viewer {

// A cube from -1 to 1 whose faces share no vertices, so that each has a normal of its own.
struct BoxMesh {
    // The corner in xyz; w is the axis that the face stands across: 0 for x, 1 for y, 2 for z.
    std::vector<Eigen::Vector4f> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

BoxMesh boxMesh();

}  // namespace drench::viewer
