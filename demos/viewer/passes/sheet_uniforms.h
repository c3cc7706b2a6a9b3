// Uniforms of one sheet; no OpenGL.
#pragma once

#include <array>
#include <optional>

#include "viewer/picture/colour_map.h"
#include "viewer/picture/picture.h"

namespace drench::viewer {

// The uniform block Sheet of sheetBlock.glsl in std140 layout; the two must be changed together.
struct SheetUniforms {
    // Smallest and largest material coordinates, m.
    std::array<float, 4> clothBounds;
    // Thread spacing, m, 0 for no threads; the weave as a number; width of the hem, m, 0 for none.
    std::array<float, 4> threading;
    // Values at the first and the last colour; 1 if values are shown, otherwise 0.
    std::array<float, 4> legend;
    // Linear RGB.
    std::array<std::array<float, 4>, colourStops> legendColours;
};

// The block of a sheet; its values are shown if there are any and the picture has a legend. Only sheets that
// are rectangles in material coordinates, but not narrow strips, have a hem.
SheetUniforms sheetUniforms(const SheetMesh& sheet, const std::optional<Legend>& legend);

}  // namespace drench::viewer
