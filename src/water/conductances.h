// How well the edges of a cloth mesh conduct: the finite elements of Darcy's law, once and for all.
#pragma once

#include <vector>

#include "drench/cloth_mesh.h"

namespace drench {

// Two nodes that water can pass between; a < b.
struct Edge {
    int a;
    int b;
    double conductance;  // positive; the unit is that of the permeability
    double length;       // m, at rest
};

// Linear finite elements on the rest mesh for a permeability of diag(warp, weft) in material coordinates.
// For warp = weft = k the conductance of an edge is k (cot a + cot b) / 2, a and b the angles opposite to
// it.
//
// An obtuse triangle would give its long edge a negative conductance, and water would flow from dry to wet.
// So the triangles first are made Delaunay, in lengths in which the permeability is the same in all
// directions, by flipping edges within the surface (intrinsic Delaunay triangulation: Fisher et al. 2007;
// Bobenko & Springborn 2007); areas of nodes stay. That leaves no negative edge but on the border, opposite
// to an obtuse angle; such an edge conducts nothing.
//
// @return one edge for each pair of nodes that conducts, by (b - a, a)
std::vector<Edge> conductances(const ClothMesh& mesh, double permeabilityWarp, double permeabilityWeft);

}  // namespace drench
