// Bending of a sheet from the positions of its nodes only.
#pragma once

#include <array>
#include <vector>

#include "drench/cloth_mesh.h"

namespace drench {

// One triangle of cloth and its neighbours, as a plate with a uniform curvature that is linear in the
// positions of the nodes.
//
// Its energy is 1/2 B area sum_m |sum_k weights[m][k] x_k|^2, in 3-D as for small deflections: cloth is flat
// at rest and hardly stretches (Bergou et al. 2006, "A quadratic bending model for inextensible surfaces").
struct PlateElement {
    // Its corners, then the far corner across the edge opposite to each; -1 where there is none, or where it
    // is already in this list.
    std::array<int, 6> nodes;
    // 1/m2. Curvature along u, along v, and sqrt(2) times the twist, in the triangle's own material
    // coordinates, so that the sum of the three squares is the same in any axes. 0 where there is no node.
    std::array<std::array<double, 6>, 3> weights;
    double area;   // m2, at rest
    int triangle;  // index
};

// The plates of a sheet, one for each triangle that has a neighbour.
//
// The heights of the nodes determine the jump of the slope at each edge of the triangle, and these jumps
// determine its curvature. Two sets of weights are known. Those of Onate and Zarate (2000, "Rotation-free
// triangular plate and shell elements", basic plate triangle; here the slope at an edge is the mean of both
// triangles by their heights over it) are in equilibrium under a uniform moment, but on irregular meshes they
// overestimate a uniform curvature. Those of the quadratic polynomial through the six nodes reproduce every
// uniform curvature, but are not in equilibrium, are too soft, and become large where the six nodes are close
// to a conic. The weights here are a least-squares compromise. With them, deflections of cantilevers and
// plates on bad meshes are accurate to a few percent; with the first set they are up to a third too small,
// with the second up to a tenth too large. On regular meshes, such as grids divided along one diagonal, all
// three are the same.
//
// An edge without a neighbour is free to rotate: curvature across it costs no energy. Non-manifold edges have
// no bending stiffness either, as if each triangle ended there.
std::vector<PlateElement> plateElements(const ClothMesh& mesh);

}  // namespace drench
