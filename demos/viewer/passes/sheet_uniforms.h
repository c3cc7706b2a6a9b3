// What the shaders know about one sheet as a whole; plain arithmetic, no OpenGL.
#pragma once

#include <array>
#include <optional>

#include "viewer/picture/colour_map.h"
#include "viewer/picture/picture.h"

namespace drench::viewer {

// The uniform block Sheet of sheetBlock.glsl in std140 layout; the two must be changed together.
struct SheetUniforms {
    // The lowest and the highest material coordinates, metres.
    std::array<float, 4> clothBounds;
    // Thread spacing in metres, 0 for no threads; the weave as a number; width of the hem in metres, 0 for none.
    std::array<float, 4> threading;
    // Values of the first and the last colour; 1 where values are to be shown, else 0.
    std::array<float, 4> legend;
    // Linear RGB.
    std::array<std::array<float, 4>, colourStops> legendColours;
};

// The block of a sheet; its values are shown where there are any and a legend says what they mean. Only sheets that are
// rectangles in material coordinates, and no narrow strips, have a hem.
SheetUniforms sheetUniforms(const SheetMesh& sheet, const std::optional<Legend>& legend);

}  // namespace drench::viewer
