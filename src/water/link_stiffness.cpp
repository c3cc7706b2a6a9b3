#include "link_stiffness.h"

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

/// The one or two triangles at an edge.
struct EdgeTriangles {
    double area = 0;             // of both together
    std::vector<int> opposites;  // the node of each triangle that is not on the edge
};

double triangleArea(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    Eigen::Matrix2d sides;
    sides << b - a, c - a;
    return 0.5 * std::abs(sides.determinant());
}

std::map<NodePair, EdgeTriangles> edgesOf(const std::vector<Eigen::Vector2d>& coordinates,
                                          const std::vector<std::array<int, 3>>& triangles) {
    std::map<NodePair, EdgeTriangles> edges;
    for (const auto& t : triangles) {
        const double area = triangleArea(coordinates[static_cast<std::size_t>(t[0])],
                                         coordinates[static_cast<std::size_t>(t[1])],
                                         coordinates[static_cast<std::size_t>(t[2])]);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            EdgeTriangles& edge = edges[pairOf(t[corner], t[(corner + 1) % 3])];
            edge.area += area;
            edge.opposites.push_back(t[(corner + 2) % 3]);
        }
    }
    return edges;
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

}  // namespace

std::vector<LinkStiffness> linkStiffness(const Fabric& fabric,
                                         const std::vector<Eigen::Vector2d>& coordinates,
                                         const std::vector<std::array<int, 3>>& triangles,
                                         const std::vector<LinkNodes>& links) {
    const auto edges = edgesOf(coordinates, triangles);
    const auto at = [&](int node) -> const Eigen::Vector2d& {
        return coordinates[static_cast<std::size_t>(node)];
    };

    // Where a link joins the far corners of two neighbouring triangles: the edge between them that it
    // crosses.
    std::map<NodePair, NodePair> crossedEdges;
    for (const auto& [edge, beside] : edges)
        if (beside.opposites.size() == 2 &&
            cross(at(edge.first), at(edge.second), at(beside.opposites[0]), at(beside.opposites[1])))
            crossedEdges.emplace(pairOf(beside.opposites[0], beside.opposites[1]), edge);

    // Area that stands behind each link; 0 where it follows no triangle.
    std::vector<double> areas(links.size(), 0.0);
    std::map<NodePair, int> crossings;
    for (std::size_t i = 0; i < links.size(); ++i) {
        if (links[i].bending) continue;
        const NodePair nodes = pairOf(links[i].nodes[0], links[i].nodes[1]);
        if (const auto edge = edges.find(nodes); edge != edges.end()) {
            areas[i] = edge->second.area;
        } else if (const auto crossed = crossedEdges.find(nodes); crossed != crossedEdges.end()) {
            areas[i] = 0.5 * edges.at(crossed->second).area;
            ++crossings[crossed->second];
        }
    }

    std::vector<LinkStiffness> result(links.size());
    for (std::size_t i = 0; i < links.size(); ++i) {
        const Eigen::Vector2d along = at(links[i].nodes[1]) - at(links[i].nodes[0]);
        const double length2 = along.squaredNorm();
        if (areas[i] > 0) {
            const bool shared = crossings.count(pairOf(links[i].nodes[0], links[i].nodes[1])) > 0;
            result[i] = {LinkKind::stretch,
                         directionalStiffness(fabric, along) * areas[i] * (shared ? 0.5 : 1.0) / length2};
        } else {
            result[i] = {LinkKind::bending, 36 * fabric.bending / length2};
        }
    }
    return result;
}

}  // namespace drench
