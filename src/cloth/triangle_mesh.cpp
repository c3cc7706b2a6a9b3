#include "drench/triangle_mesh.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <stdexcept>

#include "checks/checks.h"
#include "cloth/coincidence.h"
#include "cloth/mesh_edges.h"
#include "cloth/pieces.h"
#include "cloth/second_layer.h"
#include "cloth/welding.h"
#include "drench/cloth_mesh.h"

namespace drench {

namespace {

std::array<Eigen::Vector3d, 3> cornersOf(const TriangleMesh& mesh, std::size_t t) {
    std::array<Eigen::Vector3d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
        corners[k] = mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][k])];
    return corners;
}

void checkVertices(const TriangleMesh& mesh) {
    constexpr double furthest = 1e6;  // m
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const Eigen::Vector3d& vertex = mesh.vertices[v];
        if (!vertex.allFinite() || vertex.cwiseAbs().maxCoeff() > furthest)
            refuse("mesh: vertex ", v, " is at ", vertex, " m; give finite coordinates from -1e6 to 1e6 m");
    }
}

template <typename Error = std::invalid_argument>
void checkNodeIndices(const TriangleMesh& mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const int node : mesh.triangles[t])
            if (node < 0 || static_cast<std::size_t>(node) >= mesh.vertices.size())
                refuse<Error>("mesh: triangle ", t, " has the node ", node, "; there are ",
                              mesh.vertices.size(), ", counted from 0");
}

void checkTriangle(const TriangleMesh& mesh, std::size_t t) {
    const auto& nodes = mesh.triangles[t];
    if (nodes[0] == nodes[1] || nodes[1] == nodes[2] || nodes[2] == nodes[0])
        refuse("mesh: triangle ", t, " joins a node with itself; remove it, as weld does");
    const auto corners = cornersOf(mesh, t);
    if (!((corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() > 0))
        refuse("mesh: triangle ", t, " has no area; remove it, as weld does, or set its nodes apart");
}

void checkSecondLayer(const TriangleMesh& mesh) {
    for (const SecondLayer& layer : repeatedTriangles(mesh.triangles)) {
        const auto& nodes = mesh.triangles[layer.triangle];
        refuse("mesh: triangle ", layer.triangle, " joins the nodes ", nodes[0], ", ", nodes[1], " and ",
               nodes[2], ", as triangle ", layer.earlier,
               " does; cloth has two sides already, remove the second layer, as weld does");
    }
    for (const SecondLayer& layer : repeatedQuads(mesh.triangles, mesh.vertices))
        refuse("mesh: triangle ", layer.triangle, " is half of a quad of which triangle ", layer.earlier,
               " is half, too, with the other diagonal; cloth has two sides already, remove the second "
               "layer, as weld does");
}

void checkLoneNodes(const TriangleMesh& mesh) {
    std::vector<char> used(mesh.vertices.size(), 0);
    for (const auto& triangle : mesh.triangles)
        for (const int node : triangle) used[static_cast<std::size_t>(node)] = 1;
    const auto lone = std::find(used.begin(), used.end(), 0);
    if (lone != used.end())
        refuse("mesh: vertex ", lone - used.begin(),
               " is in no triangle, and would have no mass; remove it, as weld does");
}

void checkTexture(const TriangleMesh& mesh) {
    if (mesh.textureCoordinates.empty()) return;
    if (mesh.textureCoordinates.size() != mesh.triangles.size())
        refuse("mesh: there are texture coordinates for ", mesh.textureCoordinates.size(), " triangles of ",
               mesh.triangles.size(), "; give them for all, or none");
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const Eigen::Vector2d& corner : mesh.textureCoordinates[t])
            if (!corner.allFinite())
                refuse("mesh: the texture coordinates of triangle ", t,
                       " are not finite; give finite numbers");
}

// A triangle laid flat, its first edge along x.
std::array<Eigen::Vector2d, 3> flat(const std::array<Eigen::Vector3d, 3>& corners) {
    const Eigen::Vector3d along = (corners[1] - corners[0]).normalized(), edge = corners[2] - corners[0];
    const double foot = edge.dot(along);
    return {Eigen::Vector2d(0, 0), Eigen::Vector2d((corners[1] - corners[0]).norm(), 0),
            Eigen::Vector2d(foot, (edge - foot * along).norm())};
}

// The two edges of a triangle from its first corner, as columns.
Eigen::Matrix2d edgesOf(const std::array<Eigen::Vector2d, 3>& corners) {
    Eigen::Matrix2d edges;
    edges << corners[1] - corners[0], corners[2] - corners[0];
    return edges;
}

}  // namespace

void validate(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) refuse("mesh: it has no triangles; cloth needs at least one");
    checkVertices(mesh);
    checkNodeIndices(mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) checkTriangle(mesh, t);
    checkSecondLayer(mesh);
    checkLoneNodes(mesh);
    checkTexture(mesh);
}

void validate(const WeldOptions& options) {
    checkRange("WeldOptions::edgeFraction", options.edgeFraction, "", 0, 0.4);
    checkRange("WeldOptions::maxDistance", options.maxDistance, "m", 0, 1e6);
}

WeldedMesh weld(const TriangleMesh& mesh, const WeldOptions& options) {
    validate(options);
    checkVertices(mesh);
    checkNodeIndices(mesh);
    checkTexture(mesh);
    WeldedMesh welded = cleaned(mesh, options.join ? coincidences(mesh, options) : std::vector<int>());
    if (welded.mesh.triangles.empty())
        refuse("mesh: none of its faces has an area; cloth needs at least one that has");
    return welded;
}

std::vector<std::vector<int>> piecesOf(const TriangleMesh& mesh) {
    checkNodeIndices<std::out_of_range>(mesh);
    Pieces pieces(mesh.vertices.size());
    for (const std::array<int, 3>& triangle : mesh.triangles) {
        pieces.join(triangle[0], triangle[1]);
        pieces.join(triangle[1], triangle[2]);
    }
    std::vector<std::vector<int>> triangles;
    std::map<int, std::size_t> numbers;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [piece, isNew] = numbers.emplace(pieces.of(mesh.triangles[t][0]), triangles.size());
        if (isNew) triangles.emplace_back();
        triangles[piece->second].push_back(static_cast<int>(t));
    }
    return triangles;
}

std::vector<std::array<int, 2>> edgesOf(const TriangleMesh& mesh) {
    for (const auto& triangle : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = triangle[k], b = triangle[(k + 1) % 3];
            if (std::min(a, b) < 0 || static_cast<std::size_t>(std::max(a, b)) >= mesh.vertices.size())
                refuse<std::out_of_range>("mesh: there is no edge from node ", a, " to node ", b,
                                          "; give nodes from 0 to ", mesh.vertices.size() - 1);
        }
    return MeshEdges(mesh.triangles, mesh.vertices.size()).ends();
}

std::vector<std::array<Eigen::Vector2d, 3>> texturedCoordinates(const TriangleMesh& mesh) {
    validate(mesh);
    if (mesh.textureCoordinates.empty())
        refuse("mesh: it has no texture coordinates; lay it flat with wrappedCoordinates instead");
    std::vector<std::array<Eigen::Vector2d, 3>> coordinates;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Eigen::Matrix2d texture = edgesOf(mesh.textureCoordinates[t]);
        std::array<Eigen::Vector2d, 3> corners = flat(cornersOf(mesh, t));
        // Gradient of texture coordinate u, from u along the two edges and the inverse of the edges laid
        // flat.
        const Eigen::Vector2d warp =
            (edgesOf(corners).transpose().inverse() * texture.row(0).transpose()).normalized();
        if (!(triangleArea(mesh.textureCoordinates[t]) > 0) || !warp.allFinite())
            refuse("mesh: the texture coordinates of triangle ", t,
                   " span no area, so that its warp has no direction; mend them, or use wrappedCoordinates");
        const Eigen::Vector2d weft(-warp.y(), warp.x());
        for (Eigen::Vector2d& corner : corners) corner = Eigen::Vector2d(corner.dot(warp), corner.dot(weft));
        coordinates.push_back(corners);
    }
    return coordinates;
}

}  // namespace drench
