// Edges in an order that allows fast, vectorised loops.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "water/conductances.h"

namespace drench {

// Edges grouped into runs of neighbours: edge k of a run joins the nodes a + k and b + k. A grid consists of
// a few long runs, which are processed several edges at a time. Edges that fit into no run (on an irregular
// mesh nearly all) are processed one by one.
//
// The height difference along an edge that the motion of the sheet has stretched beyond 1.25 times its rest
// length is limited to 1.25 times the rest length, which keeps explicit steps stable on a sheet that is torn
// or unstable.
class EdgeRuns {
  public:
    static constexpr double allowedStretch = 1.25;

    // @param edges  sorted by (b - a, a)
    explicit EdgeRuns(const std::vector<Edge>& edges);

    bool empty() const { return conductance_.empty(); }

    // Moves mass along every edge: `flux(a, b, conductance, steepest)` in kg from node a to node b;
    // `steepest` is the limit of their height difference, m. The flux must not depend on the masses that are
    // being moved.
    template <typename Flux>
    void move(double* mass, const Flux& flux) const;

    // All edges.
    std::vector<Edge> edges() const;

    // Memory for all edges, bytes.
    std::size_t bytes() const {
        return runs_.size() * sizeof(Run) + loose_.size() * sizeof(Ends) +
               2 * conductance_.size() * sizeof(float);
    }

  private:
    struct Run {
        std::size_t a;      // first node at one end
        std::size_t b;      // first node at the other end
        std::size_t first;  // index of the first edge, in the given order
        std::size_t count;  // number of edges
    };
    struct Ends {
        int a, b;
    };
    // Long enough to be efficient, and short enough that the data of a run fit into the first-level cache.
    static constexpr std::size_t shortest = 8, longest = 512;

    std::vector<Run> runs_;
    std::vector<Ends> loose_;
    std::vector<float> conductance_;  // of the edges in runs, then of the others
    std::vector<float> steepest_;     // m, in the same order
};

template <typename Flux>
void EdgeRuns::move(double* mass, const Flux& flux) const {
    std::array<float, longest> moved;
    const float *conductance = conductance_.data(), *steepest = steepest_.data();
    for (const Run& run : runs_) {
        const std::size_t a = run.a, b = run.b, count = run.count;
#pragma omp simd
        for (std::size_t k = 0; k < count; ++k) moved[k] = flux(a + k, b + k, conductance[k], steepest[k]);
#pragma omp simd
        for (std::size_t k = 0; k < count; ++k) mass[a + k] -= static_cast<double>(moved[k]);
#pragma omp simd
        for (std::size_t k = 0; k < count; ++k) mass[b + k] += static_cast<double>(moved[k]);
        conductance += count;
        steepest += count;
    }
    for (const Ends& ends : loose_) {
        const auto a = static_cast<std::size_t>(ends.a), b = static_cast<std::size_t>(ends.b);
        const auto one = static_cast<double>(flux(a, b, *conductance++, *steepest++));
        mass[a] -= one;
        mass[b] += one;
    }
}

}  // namespace drench
