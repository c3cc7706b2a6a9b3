#include "cloth/link_stiffness.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "cloth/mesh_edges.h"

namespace drench {

namespace {

// A triangle seen from one of its edges, in its own material coordinates.
struct Beside {
    int opposite;                    // its node that is not on the edge
    Eigen::Vector2d from, to, apex;  // ends of the edge, lower node first, and the opposite corner
};

Beside besideOf(const ClothMesh& mesh, const EdgeTriangle& at) {
    const auto& nodes = mesh.triangles[at.triangle];
    const auto& corners = mesh.coordinates[at.triangle];
    std::size_t from = (at.apex + 1) % 3, to = (at.apex + 2) % 3;
    if (nodes[from] > nodes[to]) std::swap(from, to);
    return {nodes[at.apex], corners[from], corners[to], corners[at.apex]};
}

// Total area of the triangles at an edge, m2.
double areaAt(const ClothMesh& mesh, const MeshEdges& edges, std::size_t edge) {
    double area = 0;
    for (const EdgeTriangle& at : edges.trianglesAt(edge))
        area += triangleArea(mesh.coordinates[at.triangle]);
    return area;
}

// Apex of the second triangle at an edge when it is laid next to the first; at a seam their coordinates
// differ.
Eigen::Vector2d laidBeside(const Beside& first, const Beside& second) {
    const auto across = [](const Eigen::Vector2d& v) { return Eigen::Vector2d(-v.y(), v.x()); };
    const Eigen::Vector2d along = (first.to - first.from).normalized();
    const Eigen::Vector2d otherAlong = (second.to - second.from).normalized();
    const Eigen::Vector2d offset = second.apex - second.from;
    const double side = (first.apex - first.from).dot(across(along)) > 0 ? -1 : 1;
    return first.from + along * offset.dot(otherAlong) +
           across(along) * side * std::abs(offset.dot(across(otherAlong)));
}

// Whether the open segments a-b and c-d cross; touching ends do not count.
bool cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
           const Eigen::Vector2d& d) {
    Eigen::Matrix2d directions;
    directions << b - a, c - d;
    const double scale = (b - a).norm() * (c - d).norm();
    if (std::abs(directions.determinant()) < 1e-6 * scale) return false;
    const Eigen::Vector2d along = directions.inverse() * (c - a);
    constexpr double margin = 0.05;
    return along.minCoeff() > margin && along.maxCoeff() < 1 - margin;
}

// Young's modulus of the links in direction `along`, N/m.
double directionalStiffness(const Fabric& fabric, const Eigen::Vector2d& along) {
    const double cos2 = along.x() * along.x() / along.squaredNorm();
    const double sin2 = 1 - cos2;
    const double straight = (cos2 - sin2) * (cos2 - sin2);  // cos^2 of twice the angle
    const double shear = fabric.shear;
    return straight * ((fabric.stretchWarp - shear) * cos2 + (fabric.stretchWeft - shear) * sin2) +
           4 * shear * (1 - straight);
}

// Stiffness of a link that represents `area` of the cloth.
LinkStiffness stretchLink(const Fabric& fabric, const Eigen::Vector2d& along, double area) {
    return {LinkKind::stretch, directionalStiffness(fabric, along) * area / along.squaredNorm()};
}

}  // namespace

std::vector<LinkStiffness> linkStiffness(const Fabric& fabric, const ClothMesh& mesh,
                                         const std::vector<LinkNodes>& links) {
    const MeshEdges edges(mesh.triangles, mesh.size());

    // For a link between the far corners of two neighbouring triangles: their common edge, and the direction
    // of the link.
    struct Crossing {
        std::size_t edge;
        Eigen::Vector2d along;
    };
    std::map<NodePair, Crossing> crossings;
    for (std::size_t edge = 0; edge < edges.size(); ++edge) {
        const auto triangles = edges.trianglesAt(edge);
        if (triangles.size() != 2) continue;
        const Beside first = besideOf(mesh, triangles[0]), second = besideOf(mesh, triangles[1]);
        const Eigen::Vector2d apex = laidBeside(first, second);
        if (cross(first.from, first.to, first.apex, apex))
            crossings.emplace(pairOf(first.opposite, second.opposite), Crossing{edge, apex - first.apex});
    }

    // Edges that share their area with a link across them.
    std::vector<char> isCrossed(edges.size(), 0);
    for (const LinkNodes& link : links) {
        const NodePair nodes = pairOf(link.nodes[0], link.nodes[1]);
        if (link.bending || edges.find(nodes[0], nodes[1])) continue;
        if (const auto crossing = crossings.find(nodes); crossing != crossings.end())
            isCrossed[crossing->second.edge] = 1;
    }

    std::vector<LinkStiffness> result;
    for (const LinkNodes& link : links) {
        const NodePair nodes = pairOf(link.nodes[0], link.nodes[1]);
        const auto edge = edges.find(nodes[0], nodes[1]);
        const auto crossing = crossings.find(nodes);
        if (!link.bending && edge) {
            const Beside beside = besideOf(mesh, edges.trianglesAt(*edge)[0]);
            const double fraction = isCrossed[*edge] ? 0.5 : 1.0;
            result.push_back(
                stretchLink(fabric, beside.to - beside.from, fraction * areaAt(mesh, edges, *edge)));
        } else if (!link.bending && crossing != crossings.end()) {
            const double area = 0.5 * areaAt(mesh, edges, crossing->second.edge);
            result.push_back(stretchLink(fabric, crossing->second.along, area));
        } else if (mesh.areas[static_cast<std::size_t>(link.nodes[0])] == 0 ||
                   mesh.areas[static_cast<std::size_t>(link.nodes[1])] == 0) {
            result.push_back({LinkKind::stretch, 0.5 * (fabric.stretchWarp + fabric.stretchWeft)});
        } else {
            result.push_back({LinkKind::bending, 36 * fabric.bending / (link.length * link.length)});
        }
    }
    return result;
}

}  // namespace drench
