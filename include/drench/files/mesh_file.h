// Reads triangle meshes from OBJ files.
#pragma once

#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

#include "drench/config.h"
#include "drench/triangle_mesh.h"

namespace drench {

/// Options for OBJ files.
struct MeshReadOptions {
    /// Length of one unit of the file, m; 1e-6 to 1e6; default 1.
    double scale = 1;
    /// Whether to read texture coordinates (vt), for `texturedCoordinates`; every corner must then have them. Default:
    /// false.
    bool texture = false;
    /// How to join vertices in the same place, with distances after scaling. By default they are joined, because a mesh
    /// that was written with split vertices falls into pieces otherwise; with `weld.join = false` they are not.
    /// Vertices of different objects are joined, too: panels of a garment, but also sheets that touch each other.
    WeldOptions weld;
};

/// A mesh read from a file, and what was left out of it.
struct MeshFile {
    TriangleMesh mesh;  ///< valid: `validate` accepts it
    /// For each node the number of its first vertex in the file, from 1; it has the position of that vertex.
    std::vector<int> vertexInFile;
    /// For each vertex in the file its node; -1 for one that was left out.
    std::vector<int> nodeOfVertex;
    /// Number of objects and groups with faces; together they are the mesh.
    int objects = 0;
    /// Number of pieces: triangles that share a node, also through others, are one piece. `piecesOf` has the triangles
    /// of each. A sheet of several pieces falls apart, and is reported as Trouble::pieces.
    int pieces = 0;
    /// Number of vertices that were joined to an earlier one in the same place.
    int coincidentVertices = 0;
    /// Triangles that were left out because their area is 0, or because two of their corners were joined, by vertex
    /// numbers in the file.
    std::vector<std::array<int, 3>> degenerateTriangles;
    /// Triangles that were left out because an earlier one has the same nodes, whichever way round, or because two
    /// earlier ones are the same flat quad with its other diagonal. Of a double-sided mesh one layer is left, as cloth
    /// has two sides.
    std::vector<std::array<int, 3>> duplicateTriangles;
    /// Number of vertices that were left out because no triangle uses them.
    int unreferencedVertices = 0;
    /// Number of edges with more than two triangles. They are allowed, but have no bending stiffness.
    int nonManifoldEdges = 0;
};

/// Reads the faces of OBJ text. Quads are divided along their shorter diagonal, other polygons are triangulated.
/// Relative indices, several objects and groups are supported; normals, materials, lines and curves are ignored.
/// Vertices in the same place are joined, unless `MeshReadOptions::weld` says otherwise; texture coordinates stay with
/// the corners.
/// @throws std::invalid_argument that names the line: for a vertex or texture coordinate with too few numbers, numbers
///     that are not finite or beyond 1e6 m; for a face with less than 3 or more than 1000 corners, or an index out of
///     range. Also for text without any face of an area above 0, text of more than 256 MB or a million vertices, and
///     options out of range
DRENCH_API MeshFile meshFromText(std::string_view text, const MeshReadOptions& options = {});

/// Reads an OBJ file; see `meshFromText`.
/// @throws std::runtime_error that names the file and the reason; std::invalid_argument for options out of range
DRENCH_API MeshFile readMesh(const std::filesystem::path& path, const MeshReadOptions& options = {});

}  // namespace drench
