// Triangle meshes in space, for cloth of any shape.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "drench/config.h"

namespace drench {

/// A sheet at rest, as a triangle mesh in space. `makeSheet` in sheet.h makes a body from it.
struct TriangleMesh {
    /// Position of each node, m.
    std::vector<Eigen::Vector3d> vertices;
    /// Node indices of each triangle.
    std::vector<std::array<int, 3>> triangles;
    /// Texture coordinates of the three corners of each triangle, in any unit; empty if there are none.
    std::vector<std::array<Eigen::Vector2d, 3>> textureCoordinates;
};

/// Checks a mesh: at least one triangle; vertices finite and within 1e6 m of the origin; node indices in range;
/// triangles with three different nodes and an area, no duplicates; every node in a triangle; texture coordinates
/// finite, for all triangles or none. Non-manifold edges (more than two triangles), several pieces and holes are
/// allowed.
/// @throws std::invalid_argument that names the vertex or triangle, counted from 0
DRENCH_API void validate(const TriangleMesh& mesh);

/// All edges of a mesh, each once: two node indices, the lower one first, in ascending order.
/// @throws std::out_of_range for a node index out of range
DRENCH_API std::vector<std::array<int, 2>> edgesOf(const TriangleMesh& mesh);

/// Material coordinates from texture coordinates, for SheetSettings::faceCoordinates: each triangle is laid flat in its
/// true size, with the warp along the gradient of texture coordinate u. The texture may be in any unit, stretched or
/// mirrored.
/// @return the material coordinates of the three corners of each triangle, m; each triangle has its own origin
/// @throws std::invalid_argument as `validate`, for a mesh without texture coordinates, and for a triangle whose
///     texture coordinates span no area
DRENCH_API std::vector<std::array<Eigen::Vector2d, 3>> texturedCoordinates(const TriangleMesh& mesh);

}  // namespace drench
