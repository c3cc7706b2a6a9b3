// Triangles that lie on others of the same nodes, as in the two sides of a double-sided mesh.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

namespace drench {

// A triangle that has the nodes of earlier ones.
struct SecondLayer {
    std::size_t triangle;
    std::size_t earlier;  // one that it lies on
};

// Triangles with the same three nodes as an earlier one, in ascending order.
std::vector<SecondLayer> repeatedTriangles(const std::vector<std::array<int, 3>>& triangles);

// Pairs of triangles that are the same flat, convex quad as an earlier pair, but with its other diagonal; in no
// particular order. @pre no triangle is repeated
std::vector<SecondLayer> repeatedQuads(const std::vector<std::array<int, 3>>& triangles,
                                       const std::vector<Eigen::Vector3d>& vertices);

}  // namespace drench
