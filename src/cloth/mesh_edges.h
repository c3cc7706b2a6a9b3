// The edges of a triangle mesh, and the triangles at each edge and node.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "cloth/compressed_rows.h"

namespace drench {

// Two node indices, the lower one first.
using NodePair = std::array<int, 2>;

inline NodePair pairOf(int a, int b) {
    return {std::min(a, b), std::max(a, b)};
}

// A triangle seen from one of its edges.
struct EdgeTriangle {
    std::size_t triangle;
    std::size_t apex;  // its corner that is not on the edge, 0 to 2
};

// Each edge once, in ascending order of its nodes, with its triangles in ascending order.
class MeshEdges {
  public:
    // @param triangles  node indices of each, from 0 to nodes - 1
    MeshEdges(const std::vector<std::array<int, 3>>& triangles, std::size_t nodes);

    std::size_t size() const { return ends_.size(); }
    // Both nodes of each edge.
    const std::vector<NodePair>& ends() const { return ends_; }
    // Triangles of an edge: one at the border, two inside, more at a non-manifold edge.
    CompressedRows<EdgeTriangle>::Row trianglesAt(std::size_t edge) const { return triangles_[edge]; }
    // Index of the edge between two nodes, in either order; none if they have no triangle in common.
    std::optional<std::size_t> find(int a, int b) const;
    // The neighbour of a triangle across the edge opposite to a corner; null at the border and at
    // non-manifold edges.
    const EdgeTriangle* across(std::size_t triangle, std::size_t apex) const;

  private:
    std::vector<NodePair> ends_;
    CompressedRows<EdgeTriangle> triangles_;                // at each edge
    std::vector<std::array<std::size_t, 3>> edgeOpposite_;  // opposite to each corner of each triangle
};

// Indices of the triangles at each node, in ascending order.
CompressedRows<std::size_t> trianglesAround(const std::vector<std::array<int, 3>>& triangles,
                                            std::size_t nodes);

// Adds a third of the value of each triangle to each of its nodes.
template <typename Amount>
void addThirds(const std::array<int, 3>& triangle, Amount ofTriangle, std::vector<Amount>& ofNodes) {
    for (const int node : triangle) ofNodes[static_cast<std::size_t>(node)] += ofTriangle / 3;
}

}  // namespace drench
