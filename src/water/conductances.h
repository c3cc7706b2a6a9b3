// Conductances of the edges of a cloth mesh: finite elements of Darcy's law, computed once.
#pragma once

#include <vector>

#include "drench/cloth_mesh.h"

namespace drench {

// Two nodes between which water can flow; a < b.
struct Edge {
    int a;
    int b;
    double conductance;  // positive; the unit is that of the permeability
    double length;       // rest length, m
};

// Linear finite elements on the rest mesh for a permeability of diag(warp, weft) in material coordinates. For
// warp = weft = k the conductance of an edge is k (cot a + cot b) / 2, with a and b the angles opposite to
// it.
//
// An obtuse triangle would give its longest edge a negative conductance, and water would flow from dry to
// wet. So the triangles are first made Delaunay by flipping edges within the surface, in lengths in which the
// permeability is isotropic (intrinsic Delaunay triangulation: Fisher et al. 2007; Bobenko & Springborn
// 2007); the areas of nodes are kept. Negative conductances then remain only on the border, opposite to an
// obtuse angle; they are set to 0.
//
// @return one edge for each pair of nodes with a conductance above 0, sorted by (b - a, a)
std::vector<Edge> conductances(const ClothMesh& mesh, double permeabilityWarp, double permeabilityWeft);

}  // namespace drench
