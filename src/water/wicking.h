// Pore water that moves along the cloth by capillary forces and gravity.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "drench/cloth_mesh.h"
#include "drench/fabric.h"
#include "water/edge_runs.h"

namespace drench {

// Suction and conductivity of partly filled pores (Brooks & Corey 1964): capillary pressure p_c = p_b
// s^(-1/L) and relative permeability k_r = s^(3 + 2/L) at a saturation s, and Psi = integral of k_r |dp_c/ds|
// ds = (p_b / L) s^(3 + 1/L) / (3 + 1/L), Pa, whose differences drive wicking.
// Unlike p_c, Psi has no singularity in dry cloth.
class BrooksCorey {
  public:
    explicit BrooksCorey(const Fabric& fabric)
        : entryPressure_(fabric.entryPressure), index_(fabric.poreSizeIndex) {}

    double entryPressure() const { return entryPressure_; }
    // L = 1 needs no powers: Psi = p_b s^4 / 4 and k_r = s^5.
    bool isSimple() const { return index_ == 1; }
    double psiExponent() const { return 3 + 1 / index_; }
    double permeabilityExponent() const { return 3 + 2 / index_; }

    double psi(double s) const { return psiScale() * std::pow(s, psiExponent()); }
    double psiSlope(double s) const { return entryPressure_ / index_ * std::pow(s, psiExponent() - 1); }
    double permeability(double s) const { return std::pow(s, permeabilityExponent()); }
    double permeabilitySlope(double s) const {
        return permeabilityExponent() * std::pow(s, permeabilityExponent() - 1);
    }
    // Psi of full pores, Pa.
    double psiScale() const { return entryPressure_ / index_ / psiExponent(); }

  private:
    double entryPressure_;
    double index_;
};

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
    double largestPsiRate_ = 0;                  // largest sum of conductances over capacity of a node, m2/kg
    double largestGravityRate_ = 0;              // the same for conductance x length, m3/kg
    std::vector<float> psi_;                     // for each node, mass moved per conductance in the step, kg
    std::vector<float> permeability_;            // for each node, relative
    std::unique_ptr<ImplicitWicking> implicit_;  // made on first use
};

}  // namespace drench
