// Meshes of the solids; no OpenGL.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace drench::viewer {

struct SolidMesh {
    std::vector<Eigen::Vector4f> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

// A unit sphere cut at its equator, so that a vertex shader can move the halves apart along y: `segments` (3
// or more) vertices around the equator and `rings` (1 or more) bands on each half. A vertex has its unit
// normal in xyz; w is 0 on the lower half and 1 on the upper half.
SolidMesh capsuleMesh(std::uint32_t segments, std::uint32_t rings);

// A cube from -1 to 1 whose faces share no vertices, so that each has its own normal. A vertex has its corner
// in xyz; w is the axis perpendicular to the face: 0 for x, 1 for y, 2 for z.
SolidMesh boxMesh();

}  // namespace drench::viewer
