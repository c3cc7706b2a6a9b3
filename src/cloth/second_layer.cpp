#include "cloth/second_layer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "cloth/mesh_edges.h"

namespace drench {

namespace {

// Two triangles, and the quad that they are: its corners in order, with the diagonal from the first to the third.
struct Quad {
    std::array<std::size_t, 2> triangles;
    std::array<int, 4> corners;
};

std::array<int, 4> sorted(std::array<int, 4> nodes) {
    std::sort(nodes.begin(), nodes.end());
    return nodes;
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
    std::map<std::array<int, 3>, std::size_t> known;
    std::vector<SecondLayer> repeated;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        std::array<int, 3> nodes = triangles[t];
        std::sort(nodes.begin(), nodes.end());
        const auto [first, isNew] = known.emplace(nodes, t);
        if (!isNew) repeated.push_back({t, first->second});
    }
    return repeated;
}

std::vector<SecondLayer> repeatedQuads(const std::vector<std::array<int, 3>>& triangles,
                                       const std::vector<Eigen::Vector3d>& vertices) {
    const MeshEdges edges(triangles, vertices.size());
    const QuadCheck check(vertices);
    std::multimap<std::array<int, 4>, Quad> known;
    std::vector<SecondLayer> repeated;
    for (std::size_t edge = 0; edge < edges.size(); ++edge) {
        const auto at = edges.trianglesAt(edge);
        if (at.size() != 2) continue;
        const auto apex = [&](std::size_t i) { return triangles[at[i].triangle][at[i].apex]; };
        const auto [a, c] = edges.ends()[edge];
        const Quad quad = {{at[0].triangle, at[1].triangle}, {a, apex(0), c, apex(1)}};
        const auto [from, to] = known.equal_range(sorted(quad.corners));
        for (auto other = from; other != to; ++other) {
            if (!check.areOne(quad, other->second)) continue;
            const bool isLater = quad.triangles > other->second.triangles;
            const Quad& later = isLater ? quad : other->second;
            const Quad& earlier = isLater ? other->second : quad;
            for (const std::size_t t : later.triangles) repeated.push_back({t, earlier.triangles[0]});
        }
        known.emplace(sorted(quad.corners), quad);
    }
    return repeated;
}

}  // namespace drench
