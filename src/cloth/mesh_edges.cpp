#include "cloth/mesh_edges.h"

namespace drench {

namespace {

// An edge of a triangle, stored at its lower node.
struct FromLower {
    int upper;  // upper node
    EdgeTriangle edge;
};

CompressedRows<FromLower> edgesByLowerNode(const std::vector<std::array<int, 3>>& triangles,
                                           std::size_t nodes) {
    return {nodes, [&](const auto& add) {
                for (std::size_t t = 0; t < triangles.size(); ++t)
                    for (std::size_t apex = 0; apex < 3; ++apex) {
                        const NodePair ends =
                            pairOf(triangles[t][(apex + 1) % 3], triangles[t][(apex + 2) % 3]);
                        add(static_cast<std::size_t>(ends[0]), FromLower{ends[1], {t, apex}});
                    }
            }};
}

}  // namespace

MeshEdges::MeshEdges(const std::vector<std::array<int, 3>>& triangles, std::size_t nodes)
    : edgeOpposite_(triangles.size()) {
    const CompressedRows<FromLower> byLower = edgesByLowerNode(triangles, nodes);
    std::vector<FromLower> sorted;
    for (std::size_t lower = 0; lower < nodes; ++lower) {
        const auto row = byLower[lower];
        sorted.assign(row.begin(), row.end());
        std::sort(sorted.begin(), sorted.end(),
                  [](const FromLower& a, const FromLower& b) { return a.upper < b.upper; });
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            if (i == 0 || sorted[i].upper != sorted[i - 1].upper)
                ends_.push_back({static_cast<int>(lower), sorted[i].upper});
            edgeOpposite_[sorted[i].edge.triangle][sorted[i].edge.apex] = ends_.size() - 1;
        }
    }
    triangles_ = {ends_.size(), [&](const auto& add) {
                      for (std::size_t t = 0; t < triangles.size(); ++t)
                          for (std::size_t apex = 0; apex < 3; ++apex)
                              add(edgeOpposite_[t][apex], EdgeTriangle{t, apex});
                  }};
}

std::optional<std::size_t> MeshEdges::find(int a, int b) const {
    const NodePair ends = pairOf(a, b);
    const auto found = std::lower_bound(ends_.begin(), ends_.end(), ends);
    if (found == ends_.end() || *found != ends) return std::nullopt;
    return static_cast<std::size_t>(found - ends_.begin());
}

const EdgeTriangle* MeshEdges::across(std::size_t triangle, std::size_t apex) const {
    const auto there = trianglesAt(edgeOpposite_[triangle][apex]);
    if (there.size() != 2) return nullptr;
    const bool isFirst = there[0].triangle == triangle && there[0].apex == apex;
    return &there[isFirst ? 1 : 0];
}

CompressedRows<std::size_t> trianglesAround(const std::vector<std::array<int, 3>>& triangles,
                                            std::size_t nodes) {
    return {nodes, [&](const auto& add) {
                for (std::size_t t = 0; t < triangles.size(); ++t)
                    for (const int node : triangles[t]) add(static_cast<std::size_t>(node), t);
            }};
}

}  // namespace drench
