// Edges in the order in which a processor likes to walk them.
#pragma once

#include <cstddef>
#include <vector>

#include "conductances.h"

namespace drench {

/// Edges as runs of neighbours: edge k of a run joins the nodes a + k and b + k. A grid falls into a few long runs, which
/// are walked several edges at a time; on an irregular mesh most runs are short.
class EdgeRuns {
  public:
    struct Run {
        std::size_t a;      ///< first node on one end
        std::size_t b;      ///< first node on the other end
        std::size_t first;  ///< edge
        std::size_t count;  ///< edges, at most `longest`
    };
    /// What one run passes fits into the nearest cache.
    static constexpr std::size_t longest = 512;

    /// @param edges  by (b - a, a)
    explicit EdgeRuns(const std::vector<Edge>& edges);

    const std::vector<Run>& runs() const { return runs_; }
    /// Of each edge, by its index within the runs.
    const std::vector<float>& conductance() const { return conductance_; }
    /// All edges, in the order of the runs, without their lengths.
    std::vector<Edge> edges() const;

    /// Memory for all edges.
    std::size_t bytes() const { return runs_.size() * sizeof(Run) + conductance_.size() * sizeof(float); }

  private:
    std::vector<Run> runs_;
    std::vector<float> conductance_;
};

}  // namespace drench
