// The water on the faces: it runs down the sheet as it hangs, and falls off in drops.
#pragma once

#include <cstdint>
#include <vector>

#include "cloth/compressed_rows.h"
#include "drench/cloth_mesh.h"
#include "drench/moisture.h"
#include "water/edge_runs.h"

namespace drench {

// A film on each face that runs down under gravity (Nusselt 1916): F = 2 rho (rho g / (3 mu)) d^3 c (z_i -
// z_j) from the higher node i to the lower j, kg/s, c the cotangent weight of the edge, d the thickness
// above the film that the face retains, of the higher node. No node gives more than it has, at any length of
// step.
class FilmFlow {
  public:
    explicit FilmFlow(const ClothMesh& mesh);

    // Lets the film run for `dt` seconds.
    // @param thickest  film on any face now, m; beyond that of the cloth it does not run faster
    void run(double dt, const std::vector<float>& heights, double gravity, double thickest,
             std::vector<double>& filmMass);

    // Lets go the drops that the film cannot hold. A node with no lower neighbour keeps what hangs there
    // until it makes a drop; any other node lets go what is over the thickest film, once that makes a drop.
    // @param openAreas  of the nodes, m2; none falls from a node that is covered whole
    // @param lying      whether a node lies on something; none falls from there either
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
    std::vector<float> steepestOutflow_;    // of each node, sum of conductance x length, m
    float largestRate_ = 0;                 // of any node, steepest outflow over area, 1/m
    std::vector<float> mobility_;           // of each node, kg that a unit of conductance and height passes
    CompressedRows<Neighbour> neighbours_;  // of each node
    std::vector<int> downwards_;            // nodes from the highest to the lowest
};

}  // namespace drench
