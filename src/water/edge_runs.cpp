#include "water/edge_runs.h"

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
    // So nodes that are close in memory are processed at about the same time, whatever the direction of their
    // edges.
    std::stable_sort(runs_.begin(), runs_.end(), [](const Run& x, const Run& y) { return x.a < y.a; });
    std::stable_sort(loose.begin(), loose.end(), [](const Edge& x, const Edge& y) { return x.a < y.a; });

    const auto keep = [this](const Edge& edge) {
        conductance_.push_back(static_cast<float>(edge.conductance));
        steepest_.push_back(static_cast<float>(allowedStretch * edge.length));
    };
    for (const Run& run : runs_)
        for (std::size_t k = 0; k < run.count; ++k) keep(edges[run.first + k]);
    for (const Edge& edge : loose) {
        loose_.push_back({edge.a, edge.b});
        keep(edge);
    }
}

std::vector<Edge> EdgeRuns::edges() const {
    std::vector<Edge> edges;
    const auto add = [&](std::size_t a, std::size_t b) {
        const std::size_t i = edges.size();
        edges.push_back({static_cast<int>(a), static_cast<int>(b), double(conductance_[i]),
                         double(steepest_[i]) / allowedStretch});
    };
    for (const Run& run : runs_)
        for (std::size_t k = 0; k < run.count; ++k) add(run.a + k, run.b + k);
    for (const Ends& ends : loose_) add(static_cast<std::size_t>(ends.a), static_cast<std::size_t>(ends.b));
    return edges;
}

}  // namespace drench
