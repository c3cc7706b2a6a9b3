// Triangle meshes in space, for cloth of any shape.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "drench/config.h"

namespace drench {

/// A sheet at rest, as a triangle mesh in space. `makeSheet` in sheet.h makes a body from it.
struct TriangleMesh {
    /// Position of each node, m.
    std::vector<Eigen::Vector3d> vertices;
    /// Node indices of each triangle.
    std::vector<std::array<int, 3>> triangles;
    /// Texture coordinates of the three corners of each triangle, in any unit; empty if there are none.
    std::vector<std::array<Eigen::Vector2d, 3>> textureCoordinates;
};

/// Checks a mesh: at least one triangle; vertices finite and within 1e6 m of the origin; node indices in range;
/// triangles with three different nodes and an area; no second layer on the same nodes (the same triangle, or the two
/// of a flat quad with its other diagonal); every node in a triangle; texture coordinates finite, for all triangles or
/// none. Non-manifold edges (more than two triangles), several pieces and holes are allowed. `weld` removes what is
/// refused here, except indices out of range and numbers that are not finite.
/// @throws std::invalid_argument that names the vertex or triangle, counted from 0
DRENCH_API void validate(const TriangleMesh& mesh);

/// Which vertices count as one for `weld`: those that are no farther apart than `edgeFraction` times the mean length of
/// the edges at either of them, and no farther than `maxDistance`. With 0 only equal positions count as one.
///
/// The defaults lie between what is one point and what is not. A hundredth of an edge is more than the rounding errors
/// of float coordinates 1 km from the origin for edges of 2 cm, and of six decimals in a mesh of 1 cm for edges of 0.5
/// mm; 0.2 mm is less than the distance between the middles of two layers of cloth, however coarse their mesh is.
struct WeldOptions {
    bool join = true;  ///< false: no vertices are joined, and the mesh is only cleaned; default true
    double edgeFraction = 0.01;  ///< dimensionless; 0 to 0.4; default 0.01
    double maxDistance = 2e-4;   ///< m; 0 to 1e6; default 2e-4
};

/// Checks options. @throws std::invalid_argument for a value out of range
DRENCH_API void validate(const WeldOptions& options);

/// A mesh after `weld`, and what was done to it.
struct WeldedMesh {
    TriangleMesh mesh;  ///< valid: `validate` accepts it
    /// For each vertex of the given mesh its node in the welded one; -1 for one that was left out.
    std::vector<int> nodeOfVertex;
    /// For each node of the welded mesh the first of its vertices in the given one, whose position it has.
    std::vector<int> vertexOfNode;
    /// Number of vertices that were joined to an earlier one.
    int coincidentVertices = 0;
    /// Number of pieces of the welded mesh; see `piecesOf`.
    int pieces = 0;
    /// Triangles that were left out because welding joined two of their corners, or because their height is less than a
    /// millionth of their longest edge: indices in the given mesh.
    std::vector<int> degenerateTriangles;
    /// Triangles that were left out because an earlier one has the same nodes, whichever way round, or because two
    /// earlier ones are the same flat quad with its other diagonal: indices in the given mesh. Cloth has two sides
    /// already, so of a double-sided mesh one layer is left.
    std::vector<int> duplicateTriangles;
    /// Number of vertices that were left out because no triangle that is left uses them.
    int unreferencedVertices = 0;
    /// Number of edges with more than two triangles. They are allowed, but have no bending stiffness.
    int nonManifoldEdges = 0;
};

/// Joins coincident vertices, as programs write them for flat shading, along seams of the texture, and for the two
/// sides of a surface; without that such a mesh falls into pieces. Then removes degenerate and duplicate triangles and
/// vertices that no triangle uses. Triangles keep their order, and their corners their texture coordinates. A vertex on
/// an edge of another triangle (a T-junction) is not joined to that edge; where nothing else holds the two together,
/// `pieces` says so.
/// @throws std::invalid_argument as `validate` for vertices, node indices and texture coordinates; for options out of
///     range; and for a mesh of which nothing is left
DRENCH_API WeldedMesh weld(const TriangleMesh& mesh, const WeldOptions& options = {});

/// The triangles of each piece, in ascending order; pieces are in the order of their first triangle. Triangles belong
/// to the same piece if they share a node, also through other triangles.
/// @throws std::out_of_range for a node index out of range
DRENCH_API std::vector<std::vector<int>> piecesOf(const TriangleMesh& mesh);

/// All edges of a mesh, each once: two node indices, the lower one first, in ascending order.
/// @throws std::out_of_range for a node index out of range
DRENCH_API std::vector<std::array<int, 2>> edgesOf(const TriangleMesh& mesh);

/// Material coordinates from texture coordinates, for SheetSettings::faceCoordinates: each triangle is laid flat in its
/// true size, with the warp along the gradient of texture coordinate u. The texture may be in any unit, stretched or
/// mirrored.
/// @return the material coordinates of the three corners of each triangle, m; each triangle has its own origin
/// @throws std::invalid_argument as `validate`, for a mesh without texture coordinates, and for a triangle whose
///     texture coordinates span no area
DRENCH_API std::vector<std::array<Eigen::Vector2d, 3>> texturedCoordinates(const TriangleMesh& mesh);

}  // namespace drench
