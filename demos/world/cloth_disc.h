// A round piece of cloth as a btSoftBody.
#pragma once

#include <BulletSoftBody/btSoftBody.h>
#include <drench/drench.h>

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

namespace drench::demo {

// Triangles and links of a disc around the origin.
struct DiscMesh {
    std::vector<Eigen::Vector2d> nodes;  // m, x along the warp
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::array<int, 2>> links;
};

// A grid along warp and weft with links along both diagonals of each cell, because only such links are stiff
// along the threads and soft in shear, as woven cloth is; a mesh of equilateral triangles is much stiffer in
// shear. The border nodes of the grid are moved to the circle, and the nodes nearest to a second circle are
// moved to that one.
// @param nodesAcross  along a diameter
// @param innerRadius  of the second circle, m
DiscMesh discMesh(double radius, int nodesAcross, double innerRadius);

// The disc, horizontal, with its centre at a position and the warp along x. Masses, friction and voxel size
// are as in makeSheet.
std::unique_ptr<btSoftBody> makeDisc(btSoftBodyWorldInfo& worldInfo, const Fabric& fabric,
                                     const DiscMesh& mesh, const btVector3& centre);

}  // namespace drench::demo
