#include "edge_runs.h"

#include <algorithm>

namespace drench {

namespace {

bool follows(const Edge& edge, const Edge& before) {
    return edge.a == before.a + 1 && edge.b == before.b + 1;
}

}  // namespace

EdgeRuns::EdgeRuns(const std::vector<Edge>& edges) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const bool goesOn = i > 0 && follows(edges[i], edges[i - 1]) && runs_.back().count < longest;
        if (!goesOn)
            runs_.push_back(
                {static_cast<std::size_t>(edges[i].a), static_cast<std::size_t>(edges[i].b), i, 0});
        ++runs_.back().count;
    }
    // Nodes that are close in memory are then close in time, whatever the direction of their edges.
    std::stable_sort(runs_.begin(), runs_.end(), [](const Run& x, const Run& y) { return x.a < y.a; });

    conductance_.reserve(edges.size());
    for (Run& run : runs_) {
        const std::size_t first = conductance_.size();
        for (std::size_t k = 0; k < run.count; ++k)
            conductance_.push_back(static_cast<float>(edges[run.first + k].conductance));
        run.first = first;
    }
}

std::vector<Edge> EdgeRuns::edges() const {
    std::vector<Edge> edges;
    for (const Run& run : runs_)
        for (std::size_t k = 0; k < run.count; ++k)
            edges.push_back({static_cast<int>(run.a + k), static_cast<int>(run.b + k),
                             double(conductance_[run.first + k]), 0});
    return edges;
}

}  // namespace drench
