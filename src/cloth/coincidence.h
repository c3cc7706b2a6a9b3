// Which vertices of a mesh lie in one place.
#pragma once

#include <vector>

#include "drench/triangle_mesh.h"

namespace drench {

// For each vertex the vertex with which it counts as one: an earlier one, which counts for itself, or itself.
// Vertices that no triangle uses count for themselves. @pre node indices are in range, vertices finite
std::vector<int> coincidences(const TriangleMesh& mesh, const WeldOptions& options);

}  // namespace drench
