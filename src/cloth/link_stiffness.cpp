#include "cloth/link_stiffness.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace drench {

namespace {

using NodePair = std::pair<int, int>;

NodePair pairOf(int a, int b) {
    return {std::min(a, b), std::max(a, b)};
}

/// A triangle as seen from one of its edges, in its own material coordinates.
struct Beside {
    int opposite;                    // its node that is not on the edge
    Eigen::Vector2d from, to, apex;  // ends of the edge, lower node first, and the opposite corner
};

/// The one or two triangles at an edge.
struct EdgeTriangles {
    double area = 0;  // of both together
    std::vector<Beside> beside;
};

std::map<NodePair, EdgeTriangles> edgesOf(const ClothMesh& mesh) {
    std::map<NodePair, EdgeTriangles> edges;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& nodes = mesh.triangles[t];
        const auto& corners = mesh.coordinates[t];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            std::size_t from = corner, to = (corner + 1) % 3;
            const std::size_t apex = (corner + 2) % 3;
            if (nodes[from] > nodes[to]) std::swap(from, to);
            EdgeTriangles& edge = edges[{nodes[from], nodes[to]}];
            edge.area += triangleArea(corners);
            edge.beside.push_back({nodes[apex], corners[from], corners[to], corners[apex]});
        }
    }
    return edges;
}

/// Apex of the second triangle at an edge once it is laid beside the first; at a seam they lie apart.
Eigen::Vector2d laidBeside(const Beside& first, const Beside& second) {
    const auto across = [](const Eigen::Vector2d& v) { return Eigen::Vector2d(-v.y(), v.x()); };
    const Eigen::Vector2d along = (first.to - first.from).normalized();
    const Eigen::Vector2d otherAlong = (second.to - second.from).normalized();
    const Eigen::Vector2d offset = second.apex - second.from;
    const double side = (first.apex - first.from).dot(across(along)) > 0 ? -1 : 1;
    return first.from + along * offset.dot(otherAlong) +
           across(along) * side * std::abs(offset.dot(across(otherAlong)));
}

/// Whether the open segments a-b and c-d cross; touching ends do not count.
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

/// Young's modulus of the links in the direction of `along`, N/m.
double directionalStiffness(const Fabric& fabric, const Eigen::Vector2d& along) {
    const double cos2 = along.x() * along.x() / along.squaredNorm();
    const double sin2 = 1 - cos2;
    const double straight = (cos2 - sin2) * (cos2 - sin2);  // cos^2 of the doubled angle
    const double shear = fabric.shear;
    return straight * ((fabric.stretchWarp - shear) * cos2 + (fabric.stretchWeft - shear) * sin2) +
           4 * shear * (1 - straight);
}

/// A link along which `area` of cloth is stretched.
LinkStiffness stretchLink(const Fabric& fabric, const Eigen::Vector2d& along, double area) {
    return {LinkKind::stretch, directionalStiffness(fabric, along) * area / along.squaredNorm()};
}

}  // namespace

std::vector<LinkStiffness> linkStiffness(const Fabric& fabric, const ClothMesh& mesh,
                                         const std::vector<LinkNodes>& links) {
    const auto edges = edgesOf(mesh);

    // Where a link joins the far corners of two neighbouring triangles: the edge between them, and its own direction.
    struct Crossing {
        NodePair edge;
        Eigen::Vector2d along;
    };
    std::map<NodePair, Crossing> crossings;
    for (const auto& [edge, triangles] : edges) {
        if (triangles.beside.size() != 2) continue;
        const Beside &first = triangles.beside[0], &second = triangles.beside[1];
        const Eigen::Vector2d apex = laidBeside(first, second);
        if (cross(first.from, first.to, first.apex, apex))
            crossings.emplace(pairOf(first.opposite, second.opposite), Crossing{edge, apex - first.apex});
    }

    // How many links share the area of an edge: its own, if there is one, and one across it.
    std::map<NodePair, int> crossed;
    for (const LinkNodes& link : links) {
        const NodePair nodes = pairOf(link.nodes[0], link.nodes[1]);
        if (link.bending || edges.count(nodes) > 0) continue;
        if (const auto crossing = crossings.find(nodes); crossing != crossings.end())
            ++crossed[crossing->second.edge];
    }

    std::vector<LinkStiffness> result;
    for (const LinkNodes& link : links) {
        const NodePair nodes = pairOf(link.nodes[0], link.nodes[1]);
        const auto edge = edges.find(nodes);
        const auto crossing = crossings.find(nodes);
        if (!link.bending && edge != edges.end()) {
            const Beside& beside = edge->second.beside[0];
            const double share = crossed.count(nodes) > 0 ? 0.5 : 1.0;
            result.push_back(stretchLink(fabric, beside.to - beside.from, share * edge->second.area));
        } else if (!link.bending && crossing != crossings.end()) {
            const double area = 0.5 * edges.at(crossing->second.edge).area;
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
