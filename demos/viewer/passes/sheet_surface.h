// The vertices of a sheet for the graphics card; no OpenGL.
#pragma once

#include <optional>
#include <vector>

#include "viewer/picture/picture.h"

namespace drench::viewer {

// One node of a sheet with all values for shading.
struct SheetVertex {
    Eigen::Vector3f position;
    // Unit length, area-weighted over the triangles around the node.
    Eigen::Vector3f normal;
    Eigen::Vector3f albedo;
    float gloss;
    float dampness;
    float transmittance;
    // Curvature of the surface towards its normal, 1/m: above 0 in a hollow, below 0 on a ridge.
    float hollow;
    // Value of the quantity of the legend.
    float value;
    // How much the surface may be rounded at the node: 1 where it is smooth, 0 in a sharp fold.
    float roundness;
    // Material coordinates, m.
    Eigen::Vector2f clothCoordinates;
};

// The vertices to draw; nothing when the sheet has no triangles or a value that is not finite. Throws
// std::runtime_error when the list sizes disagree or a triangle names a node that does not exist.
std::optional<std::vector<SheetVertex>> sheetSurface(const SheetMesh& sheet);

}  // namespace drench::viewer
