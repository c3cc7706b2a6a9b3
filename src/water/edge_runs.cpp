#include "edge_runs.h"

#include <algorithm>

namespace drench {

namespace {

bool follows(const Edge& edge, const Edge& before) {
    return edge.a == before.a + 1 && edge.b == before.b + 1;
}

}  // namespace

EdgeRuns::EdgeRuns(const std::vector<Edge>& edges) {
    std::vector<Edge> loose;
    for (std::size_t first = 0; first < edges.size();) {
        std::size_t count = 1;
        while (first + count < edges.size() && count < longest &&
               follows(edges[first + count], edges[first + count - 1]))
            ++count;
        if (count >= shortest)
            runs_.push_back({static_cast<std::size_t>(edges[first].a),
                             static_cast<std::size_t>(edges[first].b), first, count});
        else
            loose.insert(loose.end(), edges.begin() + std::ptrdiff_t(first),
                         edges.begin() + std::ptrdiff_t(first + count));
        first += count;
    }
    // Nodes that are close in memory are then close in time, whatever the direction of their edges.
    std::stable_sort(runs_.begin(), runs_.end(), [](const Run& x, const Run& y) { return x.a < y.a; });
    std::stable_sort(loose.begin(), loose.end(), [](const Edge& x, const Edge& y) { return x.a < y.a; });

    for (const Run& run : runs_)
        for (std::size_t k = 0; k < run.count; ++k)
            conductance_.push_back(static_cast<float>(edges[run.first + k].conductance));
    for (const Edge& edge : loose) {
        loose_.push_back({edge.a, edge.b});
        conductance_.push_back(static_cast<float>(edge.conductance));
    }
}

std::vector<Edge> EdgeRuns::edges() const {
    std::vector<Edge> edges;
    auto conductance = conductance_.begin();
    for (const Run& run : runs_)
        for (std::size_t k = 0; k < run.count; ++k)
            edges.push_back(
                {static_cast<int>(run.a + k), static_cast<int>(run.b + k), double(*conductance++), 0});
    for (const Ends& ends : loose_) edges.push_back({ends.a, ends.b, double(*conductance++), 0});
    return edges;
}

}  // namespace drench
