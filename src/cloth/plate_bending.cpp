#include "cloth/plate_bending.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "cloth/mesh_edges.h"

namespace drench {

namespace {

// Weight of the balanced weights in the compromise. Between 0.2 and 0.6 cantilevers and plates on irregular
// meshes are accurate to a few percent; below they are too soft, above too stiff.
constexpr double leaning = 0.4;

// A triangle seen from one of its edges.
struct TriangleEdge {
    std::size_t triangle;
    std::size_t apex, from, to;  // corners; the edge runs from its lower to its higher node
    double height;               // of the apex over the edge, m
    double foot;                 // position of the foot of that height, as a fraction of the edge
};

TriangleEdge edgeOf(const ClothMesh& mesh, std::size_t triangle, std::size_t apex) {
    const auto& corners = mesh.coordinates[triangle];
    TriangleEdge edge{triangle, apex, (apex + 1) % 3, (apex + 2) % 3, 0, 0};
    const auto& nodes = mesh.triangles[triangle];
    if (nodes[edge.from] > nodes[edge.to]) std::swap(edge.from, edge.to);
    const Eigen::Vector2d along = corners[edge.to] - corners[edge.from];
    edge.height = 2 * triangleArea(corners) / along.norm();
    edge.foot = (corners[apex] - corners[edge.from]).dot(along) / along.squaredNorm();
    return edge;
}

// Symmetric tensors as vectors with the same norm.
Eigen::Vector3d square(const Eigen::Vector2d& v) {
    return {v.x() * v.x(), v.y() * v.y(), std::sqrt(2.0) * v.x() * v.y()};
}

// The relation between jumps of the slope and the curvature of a triangle.
struct Jumps {
    // One row per edge: length of the edge x jump of the slope across it, as weights of the six nodes.
    Eigen::Matrix<double, 3, 6> ofNodes = Eigen::Matrix<double, 3, 6>::Zero();
    Eigen::Matrix3d ofCurvature = Eigen::Matrix3d::Zero();  // the same for a uniform curvature, m2
    Eigen::Matrix3d balanced = Eigen::Matrix3d::Zero();     // weights of Onate and Zarate, column per edge
    Eigen::Matrix3d told = Eigen::Matrix3d::Identity();     // removes curvature across free edges
    int edges = 0;                                          // number of edges with a neighbour
};

Jumps jumpsOf(const ClothMesh& mesh, const MeshEdges& edges, std::size_t triangle, PlateElement& element) {
    Jumps jumps;
    const auto& corners = mesh.coordinates[triangle];
    for (std::size_t apex = 0; apex < 3; ++apex) {
        const TriangleEdge own = edgeOf(mesh, triangle, apex);
        const Eigen::Vector2d& from = corners[own.from];
        const Eigen::Vector2d along = corners[own.to] - from;
        const Eigen::Vector2d outward = (from + own.foot * along - corners[apex]).normalized();
        const EdgeTriangle* const neighbour = edges.across(triangle, apex);
        if (neighbour == nullptr) {
            const Eigen::Vector3d free = (jumps.told * square(outward)).normalized();
            jumps.told -= free * free.transpose();
            continue;
        }
        const TriangleEdge other = edgeOf(mesh, neighbour->triangle, neighbour->apex);
        ++jumps.edges;
        const std::size_t far = 3 + apex;
        element.nodes[far] = mesh.triangles[other.triangle][other.apex];

        const auto row = static_cast<Eigen::Index>(apex);
        const double length = along.norm();
        const auto weight = [&](std::size_t node) -> double& {
            return jumps.ofNodes(row, static_cast<Eigen::Index>(node));
        };
        weight(far) = length / other.height;
        weight(apex) = length / own.height;
        weight(own.from) = -length * ((1 - own.foot) / own.height + (1 - other.foot) / other.height);
        weight(own.to) = -length * (own.foot / own.height + other.foot / other.height);

        // The neighbour laid flat next to the triangle; at a seam their coordinates differ.
        const Eigen::Vector2d farPosition = from + other.foot * along + other.height * outward;
        jumps.ofCurvature.row(row) =
            0.5 * (weight(far) * square(farPosition - from) + weight(apex) * square(corners[apex] - from) +
                   weight(own.to) * square(along));
        jumps.balanced.col(row) = 2 * square(outward) / (length * (own.height + other.height));
    }
    return jumps;
}

// Curvature for each jump, one column per edge: the weights W that minimise |W ofCurvature - 1|^2 + leaning
// |W - balanced|^2, with each jump in units of that of a uniform curvature.
Eigen::Matrix3d compromise(const Jumps& jumps) {
    Eigen::Vector3d unit = jumps.ofCurvature.rowwise().norm();
    for (double& norm : unit)
        if (norm == 0) norm = 1;  // no neighbour at this edge
    const Eigen::Matrix3d ofCurvature = unit.cwiseInverse().asDiagonal() * jumps.ofCurvature;
    const Eigen::Matrix3d balanced = jumps.balanced * unit.asDiagonal();
    const Eigen::Matrix3d normal =
        ofCurvature * ofCurvature.transpose() + leaning * Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d weights = (ofCurvature.transpose() + leaning * balanced) * normal.inverse();
    return jumps.told * weights * unit.cwiseInverse().asDiagonal();
}

// If a far corner is also another node of the element, as around a node with three triangles, their weights
// are added.
void mergeNodes(PlateElement& element) {
    for (std::size_t far = 3; far < 6; ++far) {
        if (element.nodes[far] < 0) continue;
        const auto first = static_cast<std::size_t>(
            std::find(element.nodes.begin(), element.nodes.end(), element.nodes[far]) -
            element.nodes.begin());
        if (first == far) continue;
        for (auto& weights : element.weights) {
            weights[first] += weights[far];
            weights[far] = 0;
        }
        element.nodes[far] = -1;
    }
}

}  // namespace

std::vector<PlateElement> plateElements(const ClothMesh& mesh) {
    const MeshEdges edges(mesh.triangles, mesh.size());
    std::vector<PlateElement> elements;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const auto& corners = mesh.triangles[triangle];
        PlateElement element{};
        element.nodes = {corners[0], corners[1], corners[2], -1, -1, -1};
        element.area = triangleArea(mesh.coordinates[triangle]);
        element.triangle = static_cast<int>(triangle);
        const Jumps jumps = jumpsOf(mesh, edges, triangle, element);
        if (jumps.edges == 0) continue;
        const Eigen::Matrix<double, 3, 6> weights = compromise(jumps) * jumps.ofNodes;
        for (std::size_t m = 0; m < 3; ++m)
            for (std::size_t k = 0; k < 6; ++k)
                element.weights[m][k] = weights(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(k));
        mergeNodes(element);
        elements.push_back(element);
    }
    return elements;
}

}  // namespace drench
