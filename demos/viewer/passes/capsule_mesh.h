// The one shape that balls and rods are drawn with; plain arithmetic, no OpenGL.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace drench::viewer {

// A unit sphere cut at its equator, so that a vertex shader can pull the halves apart along y.
struct CapsuleMesh {
    // Unit normal in xyz; w is 0 on the lower half and 1 on the upper half.
    std::vector<Eigen::Vector4f> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

// `segments` (3 or more) corners round the equator and `rings` (1 or more) bands on each half.
CapsuleMesh capsuleMesh(std::uint32_t segments, std::uint32_t rings);

}  // namespace drench::viewer
