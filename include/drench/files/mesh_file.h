// Cloth from OBJ files.
#pragma once

#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

#include "drench/export.h"
#include "drench/triangle_mesh.h"

namespace drench {

/// What becomes of an OBJ file.
struct MeshReading {
    /// Metres in one unit of the file; 1e-6 to 1e6. Default 1.
    double scale = 1;
    /// Whether texture coordinates (vt) are kept, for `texturedCoordinates`; then every corner must have them. Default
    /// no.
    bool texture = false;
};

/// A mesh as a file has it, and what was left out.
struct MeshFile {
    TriangleMesh mesh;  ///< one that `validate` lets pass
    /// Of each node its vertex in the file, counted from 1 as OBJ files do.
    std::vector<int> vertexInFile;
    /// Objects and groups that have faces; all of them together are the mesh.
    int objects = 0;
    /// Triangles left out since they had no area, by their vertices in the file.
    std::vector<std::array<int, 3>> flatTriangles;
    /// Triangles left out since an earlier one joins the same vertices.
    std::vector<std::array<int, 3>> doubleTriangles;
    /// Vertices left out since no triangle has them.
    int loneVertices = 0;
    /// Sides of three and more triangles. They are allowed, and do not bend.
    int branchingSides = 0;
};

/// Reads the faces of OBJ text. Quads are cut along their shorter diagonal and other polygons into triangles; relative
/// indices, several objects and groups are understood; normals, materials, lines and curves are passed over. Faces with
/// the same vertex are joined there, and others are not, even where their vertices are at the same place.
/// @throws std::invalid_argument that names the line: for a vertex or texture coordinate that has too few numbers, ones
///     that are not finite, or that are beyond 1e6 m; for a face with less than 3 or more than 1000 corners, or an
///     index that is not there. Also for text without faces with an area, or of more than 256 MB or a million
///     vertices, and for a scale out of range.
DRENCH_API MeshFile meshFromText(std::string_view text, const MeshReading& reading = {});

/// Reads an OBJ file; see `meshFromText`.
/// @throws std::runtime_error that names the file, and says what is wrong with it; std::invalid_argument for a scale
///     out of range
DRENCH_API MeshFile readMesh(const std::filesystem::path& path, const MeshReading& reading = {});

}  // namespace drench
