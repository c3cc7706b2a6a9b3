// Water that creeps through the pores of the cloth, along it, against and with gravity.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "drench/cloth_mesh.h"
#include "drench/fabric.h"
#include "water/edge_runs.h"

namespace drench {

// How much a partly filled pore space pulls and conducts (Brooks & Corey 1964): capillary pressure
// p_c = p_b s^(-1/L) and relative permeability k_r = s^(3 + 2/L) of a saturation s, and
// Psi = integral of k_r |dp_c/ds| ds = (p_b / L) s^(3 + 1/L) / (3 + 1/L), Pa, whose differences drive wicking.
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

// The flux from node i to node j, kg/s (Darcy 1856; Richards 1931; on linear finite elements):
// F = (rho h / mu) T [Psi(s_i) - Psi(s_j) + k rho g (z_i - z_j)], T the conductance of the edge for the fabric's
// permeability. What leaves one node enters the other.
//
// k weighs the relative permeabilities of the upper and the lower node so that the lower one has the share
// min(1/2, p_b / ((3 L + 2) rho g d)), d 1.25 times the longest edge of the sheet. The mean is right to
// second order; less of the lower node keeps the flux growing with the upper one's water and falling with
// the lower one's however coarse the mesh, so that no node is drained below zero and nothing oscillates.
class Wicking {
  public:
    // Most explicit steps that a call takes before it takes one implicit step instead, which costs as much
    // as some 440 of them and is less exact (docs/water.md).
    static constexpr int maxExplicitSteps = 400;

    Wicking(const Fabric& fabric, const ClothMesh& mesh);
    ~Wicking();
    Wicking(Wicking&&) noexcept;
    Wicking& operator=(Wicking&&) noexcept;
    Wicking(const Wicking&) = delete;
    Wicking& operator=(const Wicking&) = delete;

    // Longest explicit step that keeps every store at or above zero, s.
    double explicitBound(double gravity) const;

    // Lets `dt` seconds pass. Pores may be left fuller than their capacity where gravity drives water
    // together; the caller moves the surplus to the film.
    // @param heights     of the nodes, m
    // @param capacities  of the nodes' pores, kg
    // @param poreMass    of the nodes, kg
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
    std::vector<float> inverseCapacities_;  // 1/kg; 0 for a node without cloth
    double largestPsiRate_ = 0;             // of any node, sum of conductances over capacity, m2/kg
    double largestGravityRate_ = 0;         // the same, of conductance x length, m3/kg
    std::vector<float> psi_;                // of each node, kg that a unit of conductance passes in the step
    std::vector<float> permeability_;       // of each node, relative
    std::unique_ptr<ImplicitWicking> implicit_;  // made when first needed
};

}  // namespace drench
