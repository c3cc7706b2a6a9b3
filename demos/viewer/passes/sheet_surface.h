// The vertices of a sheet for the graphics card; no OpenGL.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "viewer/picture/picture.h"

namespace drench::viewer {

// One node of a sheet with all values for shading, as five vectors of four; sheetRounding.glsl must be changed
// together with it.
struct SheetVertex {
    Eigen::Vector3f position;
    // How much the surface may be rounded at the node: 1 where it is smooth, 0 in a sharp fold.
    float roundness;
    // Unit length, area-weighted over the triangles around the node.
    Eigen::Vector3f normal;
    // Curvature of the surface towards its normal, 1/m: above 0 in a hollow, below 0 on a ridge.
    float hollow;
    Eigen::Vector3f albedo;
    // Value of the quantity of the legend.
    float value;
    // Material coordinates, m.
    Eigen::Vector2f clothCoordinates;
    float gloss;
    float dampness;
    float transmittance;
    std::array<float, 3> unused;
};
static_assert(sizeof(SheetVertex) == 20 * sizeof(float));

// The vertices to draw; nothing when the sheet has no triangles or a value that is not finite. Throws
// std::runtime_error when the list sizes disagree or a triangle names a node that does not exist.
std::optional<std::vector<SheetVertex>> sheetSurface(const SheetMesh& sheet);

}  // namespace drench::viewer
