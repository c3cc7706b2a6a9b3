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
};

/// A mesh read from a file, and what was left out of it.
struct MeshFile {
    TriangleMesh mesh;  ///< valid: `validate` accepts it
    /// For each node the number of its vertex in the file, from 1.
    std::vector<int> vertexInFile;
    /// Number of objects and groups with faces; together they are the mesh.
    int objects = 0;
    /// Triangles that were left out because their area is 0, by vertex numbers in the file.
    std::vector<std::array<int, 3>> degenerateTriangles;
    /// Triangles that were left out because an earlier one has the same vertices.
    std::vector<std::array<int, 3>> duplicateTriangles;
    /// Number of vertices that were left out because no triangle uses them.
    int unreferencedVertices = 0;
    /// Number of edges with more than two triangles. They are allowed, but have no bending stiffness.
    int nonManifoldEdges = 0;
};

/// Reads the faces of OBJ text. Quads are divided along their shorter diagonal, other polygons are triangulated.
/// Relative indices, several objects and groups are supported; normals, materials, lines and curves are ignored. Faces
/// are joined only at shared vertices, not at different vertices with equal positions.
/// @throws std::invalid_argument that names the line: for a vertex or texture coordinate with too few numbers, numbers
///     that are not finite or beyond 1e6 m; for a face with less than 3 or more than 1000 corners, or an index out of
///     range. Also for text without any face of an area above 0, text of more than 256 MB or a million vertices, and a
///     scale out of range
DRENCH_API MeshFile meshFromText(std::string_view text, const MeshReadOptions& options = {});

/// Reads an OBJ file; see `meshFromText`.
/// @throws std::runtime_error that names the file and the reason; std::invalid_argument for a scale out of range
DRENCH_API MeshFile readMesh(const std::filesystem::path& path, const MeshReadOptions& options = {});

}  // namespace drench
