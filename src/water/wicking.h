// Pore water that moves along the cloth by capillary forces and gravity.
#pragma once

#include <memory>
#include <vector>

#include "drench/cloth_mesh.h"
#include "drench/fabric.h"
#include "water/brooks_corey.h"
#include "water/edge_runs.h"

namespace drench {

class ImplicitWicking;

// The flux from node i to node j, kg/s (Darcy 1856; Richards 1931; on linear finite elements): F = (rho h /
// mu) T [Psi(s_i) - Psi(s_j) + k rho g (z_i - z_j)], with T the conductance of the edge for the fabric's
// permeability. What leaves one node enters the other.
//
// k is a weighted mean of the relative permeabilities of the upper and the lower node; the lower one has the
// weight min(1/2, p_b / ((3 L + 2) rho g d)), with d 1.25 times the longest edge of the sheet. The unweighted
// mean is second-order accurate. A smaller weight of the lower node ensures on any mesh that the flux
// increases with the water of the upper node and decreases with that of the lower node, so that no node
// becomes negative and nothing oscillates.
class Wicking {
  public:
    // Largest number of explicit steps in a call. If more are needed, one implicit step is taken instead,
    // which costs as much as about 440 of them and is less accurate (docs/water.md).
    static constexpr int maxExplicitSteps = 400;

    Wicking(const Fabric& fabric, const ClothMesh& mesh);
    ~Wicking();
    Wicking(Wicking&&) noexcept;
    Wicking& operator=(Wicking&&) noexcept;
    Wicking(const Wicking&) = delete;
    Wicking& operator=(const Wicking&) = delete;

    // Sets what the pores of a node hold, kg, until it is set again: less under pressure.
    // @param whole  without pressure, kg
    void setCapacity(std::size_t node, double capacity, double whole);

    // Longest explicit step for which no mass becomes negative, s.
    double explicitBound(double gravity) const;

    // Simulates `dt` seconds. Where gravity drives water together, pores may be filled beyond their capacity;
    // the caller moves the surplus to the film.
    // @param heights     of the nodes, m
    // @param capacities  of the pores of each node, kg
    // @param poreMass    of each node, kg
    void step(double dt, const std::vector<float>& heights, double gravity,
              const std::vector<double>& capacities, std::vector<double>& poreMass);

    // Memory for all nodes and edges, bytes, without the solver of implicit steps.
    std::size_t bytes() const;

  private:
    Wicking(const Fabric& fabric, const ClothMesh& mesh, const std::vector<Edge>& edges);

    void explicitStep(double dt, const float* heights, double gravity, double* poreMass);
    void evaluate(const double* poreMass, double psiFactor);

    BrooksCorey curve_;
    double fluxScale_;        // rho h / mu, kg/(m2 Pa s)
    double longestEdge_ = 0;  // m
    EdgeRuns runs_;
    std::vector<float> inverseCapacities_;       // 1/kg; 0 for a node without cloth
    double pressedRate_ = 1;                     // largest factor by which pressure makes a node faster
    double largestPsiRate_ = 0;                  // largest sum of conductances over capacity of a node, m2/kg
    double largestGravityRate_ = 0;              // the same for conductance x length, m3/kg
    std::vector<float> psi_;                     // for each node, mass moved per conductance in the step, kg
    std::vector<float> permeability_;            // for each node, relative
    std::unique_ptr<ImplicitWicking> implicit_;  // made on first use
};

}  // namespace drench
