#include "drench/files/mesh_file.h"

// Compiled into this library under a name of its own: an application may have another build of tinyobjloader, with
// floats, whose classes have the same names and another layout.
#define tinyobj drench_tinyobj
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "checks/checks.h"
#include "files/obj_check.h"
#include "state/whole_file.h"

namespace drench {

namespace {

constexpr std::size_t maxBytes = 256u << 20;

// The triangles of a file, with all its vertices.
TriangleMesh meshOf(const tinyobj::ObjReader& reader, const MeshReadOptions& reading) {
    const tinyobj::attrib_t& attributes = reader.GetAttrib();
    TriangleMesh mesh;
    for (std::size_t i = 0; i + 2 < attributes.vertices.size(); i += 3) {
        const double* const at = &attributes.vertices[i];
        mesh.vertices.push_back(reading.scale * Eigen::Vector3d(at[0], at[1], at[2]));
    }
    const auto texture = [&](const tinyobj::index_t& corner) -> Eigen::Vector2d {
        const double* const at = &attributes.texcoords[2 * static_cast<std::size_t>(corner.texcoord_index)];
        return {at[0], at[1]};
    };
    for (const tinyobj::shape_t& shape : reader.GetShapes()) {
        const auto& corners = shape.mesh.indices;
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
            mesh.triangles.push_back(
                {corners[i].vertex_index, corners[i + 1].vertex_index, corners[i + 2].vertex_index});
            if (reading.texture)
                mesh.textureCoordinates.push_back(
                    {texture(corners[i]), texture(corners[i + 1]), texture(corners[i + 2])});
        }
    }
    return mesh;
}

// Objects and groups with faces.
int countObjects(const std::vector<tinyobj::shape_t>& shapes) {
    return static_cast<int>(std::count_if(shapes.begin(), shapes.end(), [](const tinyobj::shape_t& shape) {
        return !shape.mesh.indices.empty();
    }));
}

// Triangles by the numbers of their vertices in the file.
std::vector<std::array<int, 3>> numbersInFile(const TriangleMesh& mesh, const std::vector<int>& triangles) {
    std::vector<std::array<int, 3>> numbers;
    for (const int t : triangles) {
        numbers.push_back(mesh.triangles[static_cast<std::size_t>(t)]);
        for (int& vertex : numbers.back()) ++vertex;
    }
    return numbers;
}

MeshFile weldedFile(const TriangleMesh& mesh, const MeshReadOptions& reading) {
    WeldedMesh welded = weld(mesh, reading.weld);
    MeshFile file;
    file.degenerateTriangles = numbersInFile(mesh, welded.degenerateTriangles);
    file.duplicateTriangles = numbersInFile(mesh, welded.duplicateTriangles);
    file.mesh = std::move(welded.mesh);
    file.vertexInFile = std::move(welded.vertexOfNode);
    for (int& vertex : file.vertexInFile) ++vertex;
    file.nodeOfVertex = std::move(welded.nodeOfVertex);
    file.pieces = welded.pieces;
    file.coincidentVertices = welded.coincidentVertices;
    file.unreferencedVertices = welded.unreferencedVertices;
    file.nonManifoldEdges = welded.nonManifoldEdges;
    return file;
}

void checkOptions(const MeshReadOptions& reading) {
    if (!(reading.scale >= 1e-6 && reading.scale <= 1e6))
        refuse("MeshReadOptions::scale is ", reading.scale, "; give metres per unit, 1e-6 to 1e6");
    validate(reading.weld);
}

// @throws std::invalid_argument with the reason
MeshFile parsed(std::string_view text, const MeshReadOptions& reading) {
    if (text.size() > maxBytes) throw std::invalid_argument("it has more than 256 MB");
    files::checkObj(text, reading);
    tinyobj::ObjReaderConfig config;
    config.triangulate = true;
    config.vertex_color = false;
    tinyobj::ObjReader reader;
    if (!reader.ParseFromString(files::withoutComments(text), "", config))
        throw std::invalid_argument(reader.Error());
    MeshFile file = weldedFile(meshOf(reader, reading), reading);
    file.objects = countObjects(reader.GetShapes());
    return file;
}

}  // namespace

MeshFile meshFromText(std::string_view text, const MeshReadOptions& reading) {
    checkOptions(reading);
    try {
        return parsed(text, reading);
    } catch (const std::invalid_argument& problem) {
        refuse("OBJ text: ", reasonOf(problem));
    }
}

MeshFile readMesh(const std::filesystem::path& path, const MeshReadOptions& reading) {
    checkOptions(reading);
    try {
        return parsed(files::readWhole(path, maxBytes), reading);
    } catch (const std::invalid_argument& problem) {
        refuse<std::runtime_error>("OBJ file ", path.string(), ": ", reasonOf(problem));
    }
}

}  // namespace drench
