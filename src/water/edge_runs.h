// Edges in the order in which a processor likes to walk them.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "water/conductances.h"

namespace drench {

// Edges as runs of neighbours: edge k of a run joins the nodes a + k and b + k. A grid falls into a few long
// runs, which are walked several edges at a time. What fits in no run, on an irregular mesh nearly
// everything, is walked one by one.
//
// An edge that the sheet's motion has stretched beyond 1.25 times its rest length counts as no steeper than
// that, which keeps explicit steps stable on a sheet that is torn or blown up.
class EdgeRuns {
  public:
    static constexpr double allowedStretch = 1.25;

    // @param edges  by (b - a, a)
    explicit EdgeRuns(const std::vector<Edge>& edges);

    bool empty() const { return conductance_.empty(); }

    // Moves mass along every edge: what `flux(a, b, conductance, steepest)` says, kg from node a to node b,
    // leaves the one and enters the other; `steepest` is by how much their heights may differ at most, m.
    // The flux must not depend on the masses that are being moved.
    template <typename Flux>
    void move(double* mass, const Flux& flux) const;

    // All edges.
    std::vector<Edge> edges() const;

    // Memory for all edges.
    std::size_t bytes() const {
        return runs_.size() * sizeof(Run) + loose_.size() * sizeof(Ends) +
               2 * conductance_.size() * sizeof(float);
    }

  private:
    struct Run {
        std::size_t a;      // first node on one end
        std::size_t b;      // first node on the other end
        std::size_t first;  // edge, in the order given
        std::size_t count;  // edges
    };
    struct Ends {
        int a, b;
    };
    // Long enough to pay, and short enough that what a run moves fits into the nearest cache.
    static constexpr std::size_t shortest = 8, longest = 512;

    std::vector<Run> runs_;
    std::vector<Ends> loose_;
    std::vector<float> conductance_;  // of the edges in runs, then of the loose ones
    std::vector<float> steepest_;     // m, of the same
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
