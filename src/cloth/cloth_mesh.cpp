#include "drench/cloth_mesh.h"
#include "checks/checks.h"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>
#include <string>

#include "cloth/mesh_edges.h"

namespace drench {

namespace {

std::string missingNode(std::size_t triangle, int node, std::size_t nodes) {
    return textOf("triangle ", triangle, " has the node ", node, "; ",
                  nodes > 0 ? textOf("give 0 to ", nodes - 1) : "there are none");
}

bool isThere(int node, std::size_t nodes) {
    return node >= 0 && static_cast<std::size_t>(node) < nodes;
}

void checkTriangle(const ClothMesh& mesh, std::size_t t) {
    const auto& nodes = mesh.triangles[t];
    for (const int node : nodes)
        if (!isThere(node, mesh.size())) refuse(missingNode(t, node, mesh.size()));
    if (nodes[0] == nodes[1] || nodes[1] == nodes[2] || nodes[2] == nodes[0])
        refuse("triangle ", t, " joins a node with itself; remove it");
    for (const Eigen::Vector2d& corner : mesh.coordinates[t])
        if (!corner.allFinite())
            refuse("the material coordinates of triangle ", t, " are not finite; give metres");
    if (!(triangleArea(mesh.coordinates[t]) > 0))
        refuse("triangle ", t, " has no area in material coordinates; remove it");
}

}  // namespace

double triangleArea(const std::array<Eigen::Vector2d, 3>& corners) {
    Eigen::Matrix2d edges;
    edges << corners[1] - corners[0], corners[2] - corners[0];
    return 0.5 * std::abs(edges.determinant());
}

ClothMesh flatMesh(const std::vector<Eigen::Vector2d>& coordinates,
                   const std::vector<std::array<int, 3>>& triangles) {
    ClothMesh mesh;
    mesh.areas.assign(coordinates.size(), 0.0);
    mesh.triangles = triangles;
    for (const auto& nodes : triangles) {
        std::array<Eigen::Vector2d, 3> corners;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            if (!isThere(nodes[corner], coordinates.size()))
                refuse<std::out_of_range>(
                    missingNode(mesh.coordinates.size(), nodes[corner], coordinates.size()));
            corners[corner] = coordinates[static_cast<std::size_t>(nodes[corner])];
        }
        addThirds(nodes, triangleArea(corners), mesh.areas);
        mesh.coordinates.push_back(corners);
    }
    return mesh;
}

void validate(const ClothMesh& mesh) {
    for (std::size_t node = 0; node < mesh.size(); ++node)
        if (!(mesh.areas[node] >= 0) || !std::isfinite(mesh.areas[node]))
            refuse("node ", node, " has an area of ", mesh.areas[node],
                   " m2; give a third of its rest triangles, at least 0");
    if (mesh.coordinates.size() != mesh.triangles.size())
        refuse("there are material coordinates for ", mesh.coordinates.size(), " triangles, but ",
               mesh.triangles.size(), " triangles; give those of the three corners of each");
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) checkTriangle(mesh, t);
}

}  // namespace drench
