// Divides the triangles of sheets, so that their surfaces can be rounded; no OpenGL.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace drench::viewer {

using Triangle = std::array<std::uint32_t, 3>;

// A vertex of a divided sheet: the mean of three nodes by these weights, whose sum is 1.
struct DividedVertex {
    std::array<std::uint32_t, 3> corners;
    std::array<float, 3> weights;
};

struct DividedSheet {
    // The nodes come first, as they are numbered; then what divides the edges, which neighbours have in common,
    // and the insides of triangles. Empty if nothing is divided: then the nodes are the vertices.
    std::vector<DividedVertex> vertices;
    // As the undivided ones are oriented.
    std::vector<Triangle> triangles;
};

// Divides each edge of a sheet of so many nodes into so many pieces, and each triangle into their square.
DividedSheet divided(std::size_t nodes, const std::vector<Triangle>& triangles, std::uint32_t pieces);

// The division of one sheet from frame to frame.
class SheetDivision {
  public:
    // Sheets of more nodes than these are not divided.
    explicit SheetDivision(std::size_t maxNodes) : maxNodes_(maxNodes) {}

    // Returns the divided sheet if its nodes or triangles are others than in the last call. Edges have three
    // pieces, in sheets of many triangles two, in those of very many one.
    std::optional<DividedSheet> update(std::size_t nodes, const std::vector<Triangle>& triangles);

  private:
    std::size_t maxNodes_;
    std::size_t nodes_ = 0;
    std::vector<Triangle> triangles_;
};

}  // namespace drench::viewer
