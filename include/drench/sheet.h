// Makes btSoftBodies that are sheets of cloth: rectangular grids, and any triangle mesh.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "drench/config.h"
#include "drench/fabric.h"
#include "drench/triangle_mesh.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// Positions of the four corners of a sheet, m. The warp (material coordinate u) runs from `origin` to `warpEnd`, the
/// weft (v) from `origin` to `weftEnd`.
struct Corners {
    btVector3 origin;    ///< node (0, 0)
    btVector3 warpEnd;   ///< end of the first row
    btVector3 weftEnd;   ///< start of the last row
    btVector3 opposite;  ///< end of the last row
};

/// Corners of a parallelogram, from one corner and the vectors along its two edges, m.
DRENCH_API Corners flatCorners(const btVector3& origin, const btVector3& warpEdge, const btVector3& weftEdge);

/// Makes a grid of nodesWarp x nodesWeft nodes. Node (i, j) has index i + j nodesWarp; nodes are evenly spaced.
///
/// Links: structural links along both directions, both diagonals of each cell for shear, and links over two cells for
/// bending (marked m_bbending). They are sorted by graph colouring, which keeps Bullet's sweeps stable. Node masses are
/// those of the dry fabric; the margin is a quarter of a cell, at most 20 mm; the friction is that of the dry fabric on
/// a smooth plate. With a `WetCloth` and a SmallStepSolver it meets itself and other such sheets (see SheetSettings);
/// otherwise it passes through itself, and collides with other soft bodies only if both have fCollision::VF_SS in
/// m_cfg.collisions, which is not set here. Stiffness in N/m needs a `WetCloth`; without one the sheet is an ordinary patch.
///
/// If the voxel size of `worldInfo.m_sparsesdf` is larger than a cell it is set to half a cell, because contacts would
/// otherwise be found at wrong positions.
///
/// @param worldInfo  of the sheet's world; must outlive the body
/// @param nodesWarp, nodesWeft  number of nodes in each direction; 2 to 10,000
/// @return the body. The application must add it to its world, and remove it before it is destroyed
/// @throws std::invalid_argument for a fabric or number of nodes out of range, or corners that are not finite or give a
///     face without area
DRENCH_API std::unique_ptr<btSoftBody> makeSheet(btSoftBodyWorldInfo& worldInfo, const Fabric& fabric,
                                                 const Corners& corners, int nodesWarp, int nodesWeft);

/// Makes a body from a triangle mesh: one node per vertex, one face per triangle. The mesh is its rest shape.
///
/// Links: one along each edge, and one across each edge that looks like the diagonal of a quad, so that the quad has
/// both diagonals and shears as woven cloth does: an edge of two nearly coplanar triangles that is the longest edge of
/// both by at least a tenth. They are sorted by graph colouring. Masses, margin, friction and voxel size are as in the
/// other `makeSheet`, with the mean length of a link in place of a cell. There are no links for bending: the
/// SmallStepSolver and the deformable world need none, with the stock solver such a sheet bends freely.
///
/// A mesh that is not flat needs SheetSettings::faceCoordinates, from `wrappedCoordinates` or `texturedCoordinates`.
/// @param worldInfo  of the sheet's world; must outlive the body
/// @return the body. The application must add it to its world, and remove it before it is destroyed
/// @throws std::invalid_argument for a fabric out of range, a mesh that `validate` refuses, or a triangle whose area
///     is 0 in Bullet's precision
DRENCH_API std::unique_ptr<btSoftBody> makeSheet(btSoftBodyWorldInfo& worldInfo, const Fabric& fabric,
                                                 const TriangleMesh& mesh);

/// Pins nodes: sets their inverse masses to 0.
/// @throws std::out_of_range for a node that does not exist; nothing is then pinned
DRENCH_API void pin(btSoftBody& body, const std::vector<int>& nodes);

/// Pins all nodes for whose position, m, `isPinned` returns true. @return their indices
DRENCH_API std::vector<int> pinWhere(btSoftBody& body,
                                     const std::function<bool(const btVector3& position)>& isPinned);

/// Material coordinates for cloth that is wrapped around an axis, such as a sleeve, for SheetSettings::faceCoordinates.
/// Each face is laid flat in its present shape, with the weft along the projection of `axis` onto the face and the warp
/// perpendicular to it. In a face perpendicular to the axis the weft is along the first edge.
/// @param axis  of any length above 0
/// @return the material coordinates of the three corners of each face, m; each face has its own origin
/// @throws std::invalid_argument for an axis that is not finite or has length 0
DRENCH_API std::vector<std::array<Eigen::Vector2d, 3>> wrappedCoordinates(const btSoftBody& body,
                                                                          const btVector3& axis);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
