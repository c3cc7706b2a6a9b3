// Bending of a sheet whose triangles know only where their nodes are.
#pragma once

#include <array>
#include <vector>

#include "drench/cloth_mesh.h"

namespace drench {

// One triangle of cloth together with the triangles across its edges, as a plate whose curvature is the same
// everywhere and linear in the positions of the nodes.
//
// Its energy is 1/2 B area sum_m |sum_k weights[m][k] x_k|^2, in 3-D as for small heights: cloth is flat at
// rest and hardly stretches (Bergou et al. 2006, "A quadratic bending model for inextensible surfaces").
struct PlateElement {
    // Its corners, then the far corner across the edge opposite to each; -1 where there is none, or where it
    // is a node that this list already has.
    std::array<int, 6> nodes;
    // 1/m2. Curvature along u, along v, and sqrt(2) times the twist, in the triangle's own material
    // coordinates: so the squares of the three add up to the same in any axes. 0 where there is no node.
    std::array<std::array<double, 6>, 3> weights;
    double area;  // m2, at rest
};

// The plates of a sheet, one for each triangle that has a neighbour.
//
// What the heights of a patch say about its curvature is how much their slope jumps at each edge of the
// triangle. Two sets of weights are at hand. Those of Onate and Zarate (2000, "Rotation-free triangular
// plate and shell elements", basic plate triangle; here an edge's slope is the mean of both triangles by
// their heights over it) balance under an even moment, but on uneven meshes see more than an even
// curvature. Those of the quadratic through the six nodes see every even curvature, but do not balance,
// are too soft, and large where the six lie near a conic. The weights here are a least-squares compromise:
// cantilevers and plates on badly cut meshes deflect right within some percent, where the first alone
// deflect up to a third too little and the second up to a tenth too much. On even meshes, such as grids
// cut along one diagonal, all three are the same.
//
// Where an edge has no neighbour the cloth is free to turn: curvature across that edge costs nothing. An edge
// of three or more triangles has no bending across it either, as if each ended there.
std::vector<PlateElement> plateElements(const ClothMesh& mesh);

}  // namespace drench
