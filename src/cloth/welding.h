// Removes from a mesh what is no cloth.
#pragma once

#include <vector>

#include "drench/triangle_mesh.h"

namespace drench {

// The mesh after vertices were joined, without degenerate and duplicate triangles and without unused vertices. It may
// have no triangles.
// @param sameAs  for each vertex an earlier one to which it is joined, which is joined to none, or itself; empty: all
//     vertices stay apart
// @pre node indices are in range, vertices finite, and there are texture coordinates for all triangles or none
WeldedMesh cleaned(const TriangleMesh& mesh, const std::vector<int>& sameAs);

}  // namespace drench
