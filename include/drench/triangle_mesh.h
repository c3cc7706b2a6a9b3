// Cloth of any shape, as triangles in space.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "drench/export.h"

namespace drench {

/// Where the nodes of a sheet are at rest, and which triangles they span. `makeSheet` in sheet.h makes a body of it.
struct TriangleMesh {
    /// Of each node, m.
    std::vector<Eigen::Vector3d> vertices;
    /// Node indices of each triangle.
    std::vector<std::array<int, 3>> triangles;
    /// Texture coordinates of each triangle's three corners, in whatever unit; empty if there are none.
    std::vector<std::array<Eigen::Vector2d, 3>> textureCoordinates;
};

/// Checks a mesh: at least one triangle, vertices finite and within 1e6 m, node indices that are there, triangles of
/// three different nodes, with an area, and none twice, every node in a triangle, finite texture coordinates for all
/// triangles or for none. Sides of three and more triangles, several pieces and holes are allowed.
/// @throws std::invalid_argument that names the vertex or triangle, counted from 0
DRENCH_API void validate(const TriangleMesh& mesh);

/// The sides of a mesh, each once: its two nodes, the lower first, in ascending order.
/// @throws std::out_of_range for a node that is not there
DRENCH_API std::vector<std::array<int, 2>> sidesOf(const TriangleMesh& mesh);

/// Material coordinates for SheetSettings::faceCoordinates by the texture of a mesh, as clothes are usually cut: each
/// triangle is laid flat at its true size, with the warp in the direction in which u rises, as far as that lies in it;
/// so a texture may be in any unit, and stretched. u and v may run either way round.
/// @return the three corners of each triangle, m, each triangle by itself
/// @throws std::invalid_argument as `validate`, for a mesh without texture coordinates, and for a triangle whose
///     texture coordinates span no area, which then have no direction
DRENCH_API std::vector<std::array<Eigen::Vector2d, 3>> texturedCoordinates(const TriangleMesh& mesh);

}  // namespace drench
