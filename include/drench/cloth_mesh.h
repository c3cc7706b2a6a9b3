// How the cloth of a sheet is cut, for everything that depends on where warp and weft run.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "drench/export.h"

namespace drench {

/// The nodes and triangles of a sheet at rest, laid out flat in material coordinates: u along the warp, v
/// along the weft.
struct ClothMesh {
    /// Cloth area of each node, m2, a third of its rest triangles; 0 for a node without cloth.
    std::vector<double> areas;
    /// Node indices of each triangle.
    std::vector<std::array<int, 3>> triangles;
    /// Material coordinates of each triangle's three corners, m. Neighbouring triangles agree on the length of
    /// the side between them; at a seam, as along a sleeve, they may lie apart.
    std::vector<std::array<Eigen::Vector2d, 3>> coordinates;

    /// Number of nodes.
    std::size_t size() const { return areas.size(); }
};

/// Area of a triangle in material coordinates, m2.
DRENCH_API double triangleArea(const std::array<Eigen::Vector2d, 3>& corners);

/// A sheet without seams.
/// @param coordinates  of each node, m
/// @param triangles    node indices of each triangle
/// @throws std::out_of_range for a node that is not there
DRENCH_API ClothMesh flatMesh(const std::vector<Eigen::Vector2d>& coordinates,
                              const std::vector<std::array<int, 3>>& triangles);

/// Checks that areas are finite and not negative, that every triangle joins three different nodes that are
/// there, and that its coordinates are finite and span an area.
/// @throws std::invalid_argument that names the node or triangle
DRENCH_API void validate(const ClothMesh& mesh);

}  // namespace drench
