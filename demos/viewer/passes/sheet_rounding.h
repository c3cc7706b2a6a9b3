// Subdivides the triangles of sheets into curved surfaces; no OpenGL.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "viewer/passes/sheet_surface.h"

namespace drench::viewer {

// A sheet as triangles to draw.
struct SheetTriangles {
    std::vector<SheetVertex> vertices;
    // Three indices into vertices each.
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

// Divides every triangle and bends the parts to follow the normals at its corners, so that cloth on a ball
// looks round and the ball does not show through flat facets. The nodes themselves do not move. Sheets of
// very many triangles are divided less.
SheetTriangles rounded(const std::vector<SheetVertex>& nodes,
                       const std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace drench::viewer
