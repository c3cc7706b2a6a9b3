#include "cloth/second_layer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>
#include <utility>

#include "cloth/mesh_edges.h"

namespace drench {

namespace {

// Two triangles, and the quad that they are: its corners in order, with the diagonal from the first to the third.
struct Quad {
    std::array<std::size_t, 2> triangles;
    std::array<int, 4> corners;
    std::array<int, 4> nodes;  // its corners in ascending order
};

// All quads with one edge as diagonal; those with the same nodes follow each other.
std::vector<Quad> quadsOf(const std::vector<std::array<int, 3>>& triangles, std::size_t nodes) {
    const MeshEdges edges(triangles, nodes);
    std::vector<Quad> quads;
    quads.reserve(edges.size());
    for (std::size_t edge = 0; edge < edges.size(); ++edge) {
        const auto at = edges.trianglesAt(edge);
        if (at.size() != 2) continue;
        const auto apex = [&](std::size_t i) { return triangles[at[i].triangle][at[i].apex]; };
        const auto [a, c] = edges.ends()[edge];
        const std::array<int, 4> corners = {a, apex(0), c, apex(1)};
        quads.push_back({{at[0].triangle, at[1].triangle}, corners, corners});
        std::sort(quads.back().nodes.begin(), quads.back().nodes.end());
    }
    std::sort(quads.begin(), quads.end(), [](const Quad& one, const Quad& other) {
        return std::tie(one.nodes, one.triangles) < std::tie(other.nodes, other.triangles);
    });
    return quads;
}

class QuadCheck {
  public:
    explicit QuadCheck(const std::vector<Eigen::Vector3d>& vertices) : vertices_(vertices) {}

    // Whether quads with the same nodes are one flat, convex quad with both diagonals: the triangles of both then face
    // the same way round the quad.
    bool areOne(const Quad& one, const Quad& other) const {
        const auto& [a, b, c, d] = one.corners;
        if (pairOf(b, d) != pairOf(other.corners[0], other.corners[2])) return false;
        return faceAlike(normal(a, b, c), normal(a, c, d)) && faceAlike(normal(a, b, d), normal(b, c, d));
    }

  private:
    Eigen::Vector3d normal(int a, int b, int c) const {
        const auto at = [&](int node) { return vertices_[static_cast<std::size_t>(node)]; };
        return (at(b) - at(a)).cross(at(c) - at(a)).normalized();
    }
    static bool faceAlike(const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
        constexpr double flat = 0.9;  // cosine of the angle between them
        return one.dot(other) > flat;
    }

    const std::vector<Eigen::Vector3d>& vertices_;
};

}  // namespace

std::vector<SecondLayer> repeatedTriangles(const std::vector<std::array<int, 3>>& triangles) {
    using Named = std::pair<std::array<int, 3>, std::size_t>;
    std::vector<Named> sorted;
    sorted.reserve(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        sorted.emplace_back(triangles[t], t);
        std::sort(sorted.back().first.begin(), sorted.back().first.end());
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<SecondLayer> repeated;
    for (std::size_t i = 1, first = 0; i < sorted.size(); ++i)
        if (sorted[i].first == sorted[first].first)
            repeated.push_back({sorted[i].second, sorted[first].second});
        else
            first = i;
    std::sort(repeated.begin(), repeated.end(),
              [](const SecondLayer& a, const SecondLayer& b) { return a.triangle < b.triangle; });
    return repeated;
}

std::vector<SecondLayer> repeatedQuads(const std::vector<std::array<int, 3>>& triangles,
                                       const std::vector<Eigen::Vector3d>& vertices) {
    const std::vector<Quad> quads = quadsOf(triangles, vertices.size());
    const QuadCheck check(vertices);
    std::vector<SecondLayer> repeated;
    for (std::size_t i = 0; i < quads.size(); ++i)
        for (std::size_t j = i + 1; j < quads.size() && quads[j].nodes == quads[i].nodes; ++j) {
            if (!check.areOne(quads[i], quads[j])) continue;
            const bool isLater = quads[i].triangles > quads[j].triangles;
            const Quad& later = quads[isLater ? i : j];
            const Quad& earlier = quads[isLater ? j : i];
            for (const std::size_t t : later.triangles) repeated.push_back({t, earlier.triangles[0]});
        }
    return repeated;
}

}  // namespace drench
