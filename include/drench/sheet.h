// A rectangular cloth as a btSoftBody.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "drench/export.h"
#include "drench/fabric.h"
#include "drench/precision.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// Where the four corners of a sheet are, m. The warp (material coordinate u) runs from `origin` to `warpEnd`, the weft
/// (v) from `origin` to `weftEnd`.
struct Corners {
    btVector3 origin;    ///< of node (0, 0)
    btVector3 warpEnd;   ///< at the end of the first row
    btVector3 weftEnd;   ///< at the beginning of the last row
    btVector3 opposite;  ///< at the end of the last row
};

/// A parallelogram with one corner and its two sides, m.
DRENCH_API Corners flatCorners(const btVector3& origin, const btVector3& warpSide, const btVector3& weftSide);

/// Makes a grid of nodesWarp x nodesWeft nodes; node (i, j) has index i + j nodesWarp and sits at i /
/// (nodesWarp - 1) of the way along the warp and j / (nodesWeft - 1) along the weft.
///
/// Links: structural along both directions, both diagonals of each cell for shear, and two cells apart for
/// bending (marked m_bbending). They are ordered in colours, no two links of a colour sharing a node, which
/// keeps Bullet's sweeps stable. Node masses are those of the dry fabric, the margin a quarter of a cell but
/// at most 20 mm, the friction that of the dry fabric on a smooth plate. Stiffness in N/m comes with
/// `WetCloth`; without one the sheet is an ordinary patch.
///
/// A voxel size of `worldInfo.m_sparsesdf` that is coarser than a cell is refined to half a cell, since with
/// it the sheet could not touch anything where it is.
///
/// @param worldInfo  of the world that the sheet goes into; must outlive it
/// @param nodesWarp, nodesWeft  2 to 10,000 each
/// @return the body; the application adds it to its world, and removes it before it lets go
/// @throws std::invalid_argument for a fabric out of range, a node count out of range, or corners that are
///     not finite or leave a face without area.
DRENCH_API std::unique_ptr<btSoftBody> makeSheet(btSoftBodyWorldInfo& worldInfo, const Fabric& fabric,
                                                 const Corners& corners, int nodesWarp, int nodesWeft);

/// Material coordinates for cloth that is wrapped around something, as a sleeve is, for
/// SheetSettings::faceCoordinates: each face is laid flat as it is now, the weft along `axis` as far as it
/// lies in the face, the warp around. Across the axis, where a face lies in neither direction, the weft runs
/// along the face's first side.
/// @param axis  of any length above 0
/// @return the three corners of each face, m, each face by itself
/// @throws std::invalid_argument for an axis that is not finite or has no length
DRENCH_API std::vector<std::array<Eigen::Vector2d, 3>> wrappedCoordinates(const btSoftBody& body,
                                                                          const btVector3& axis);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
