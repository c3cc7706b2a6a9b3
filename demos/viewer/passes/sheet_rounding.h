// Curved triangles for sheets; plain arithmetic, no OpenGL.
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

// Splits every triangle and bends the pieces to follow the normals at its corners, so that cloth round a ball
// looks round and the ball does not show through flat facets. The nodes themselves stay where they are.
// Sheets of very many triangles are fine enough as they are and are split less.
SheetTriangles rounded(const std::vector<SheetVertex>& nodes,
                       const std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace drench::viewer
