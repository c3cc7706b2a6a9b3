// A sheet of cloth at rest, in material coordinates.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "drench/config.h"

namespace drench {

/// Nodes and triangles of a sheet at rest, laid flat in material coordinates: u along the warp, v along the weft.
struct ClothMesh {
    /// Rest area of each node, m2: a third of the areas of its triangles; 0 for a node without triangles.
    std::vector<double> areas;
    /// Node indices of each triangle.
    std::vector<std::array<int, 3>> triangles;
    /// Material coordinates of the three corners of each triangle, m. Neighbouring triangles must agree on the
    /// length of their common edge; at a seam (along a sleeve, say) the coordinates themselves may differ.
    std::vector<std::array<Eigen::Vector2d, 3>> coordinates;

    /// Number of nodes.
    std::size_t size() const { return areas.size(); }
};

/// Area of a triangle in material coordinates, m2.
DRENCH_API double triangleArea(const std::array<Eigen::Vector2d, 3>& corners);

/// Mesh of a sheet without seams.
/// @param coordinates  material coordinates of each node, m
/// @param triangles    node indices of each triangle
/// @throws std::out_of_range for a node index out of range
DRENCH_API ClothMesh flatMesh(const std::vector<Eigen::Vector2d>& coordinates,
                              const std::vector<std::array<int, 3>>& triangles);

/// Checks that areas are finite and not negative, that every triangle has three different, existing nodes, and that
/// its coordinates are finite and its area is not 0.
/// @throws std::invalid_argument that names the node or triangle
DRENCH_API void validate(const ClothMesh& mesh);

}  // namespace drench
