// Film water on the faces: it runs down the sheet and drips.
#pragma once

#include <cstdint>
#include <vector>

#include "cloth/compressed_rows.h"
#include "drench/cloth_mesh.h"
#include "drench/moisture.h"
#include "water/edge_runs.h"

namespace drench {

// A film on each face that runs down under gravity (Nusselt 1916): F = 2 rho (rho g / (3 mu)) d^3 c (z_i -
// z_j) from the higher node i to the lower node j, kg/s, with c the cotangent weight of the edge, and d the
// film thickness of the higher node minus the retained film. No node loses more than it has, at any length of
// step.
class FilmFlow {
  public:
    explicit FilmFlow(const ClothMesh& mesh);

    // Simulates the film for `dt` seconds.
    // @param thickest  largest film thickness on any face now, m; a film thicker than the largest film of the
    //     cloth does not run faster
    void run(double dt, const std::vector<float>& heights, double gravity, double thickest,
             std::vector<double>& filmMass);

    // Removes the drops that the film cannot hold. A node without a lower neighbour keeps its film until
    // there is enough for a drop; any other node loses what exceeds the thickest film, once that is enough
    // for a drop.
    // @param openAreas  of the nodes, m2; a completely covered node does not drip
    // @param lying      whether a node lies on a solid; then it does not drip either
    void drip(const std::vector<float>& heights, const std::vector<float>& openAreas,
              const std::vector<char>& lying, std::vector<double>& filmMass,
              std::vector<Moisture::Shed>& shed);

    // Memory for all nodes and edges, bytes.
    std::size_t bytes() const;

  private:
    struct Neighbour {
        int node;
        float conductance;
    };

    FilmFlow(const ClothMesh& mesh, const std::vector<Edge>& edges);

    void runInSteps(double dt, int steps, const float* heights, double gravity, double* filmMass);
    void runInSweeps(double dt, const std::vector<float>& heights, double gravity, double* filmMass);
    void sweepDown(double dt, const float* heights, double gravity, double* filmMass);
    bool hasLowerNeighbour(std::size_t node, const std::vector<float>& heights) const;

    EdgeRuns runs_;
    std::vector<float> areas_;              // m2
    std::vector<float> inverseAreas_;       // 1/m2; 0 for a node without cloth
    std::vector<float> steepestOutflow_;    // for each node, sum of conductance x length, m
    float largestRate_ = 0;                 // largest steepest outflow over area, 1/m
    std::vector<float> mobility_;           // of each node, kg per conductance and height
    CompressedRows<Neighbour> neighbours_;  // of each node
    std::vector<int> downwards_;            // nodes from the highest to the lowest
};

}  // namespace drench
