// Wicking in a long step: one implicit step instead of many explicit ones.
#pragma once

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <vector>

#include "water/conductances.h"
#include "water/wicking.h"

namespace drench {

// The same fluxes as `Wicking`, evaluated at the end of the step (backward Euler): stable at any length.
// Newton's method with a sparse linear solver; a step that does not converge is halved.
class ImplicitWicking {
  public:
    // @param fluxScale   rho h / mu
    // @param capacities  of the pores of each node, kg
    ImplicitWicking(const BrooksCorey& curve, double fluxScale, const std::vector<Edge>& edges,
                    const std::vector<double>& capacities);

    // Sets what the pores of a node hold, kg.
    void setCapacity(std::size_t node, double capacity) { capacities_[node] = capacity; }

    // @param weight      rho g, Pa/m
    // @param lowerFraction  weight of the lower node in the permeability to gravity
    void step(double dt, const std::vector<float>& heights, double weight, double lowerFraction,
              std::vector<double>& poreMass);

  private:
    // Flux along an edge and its derivatives with respect to the saturations of its ends, kg/s.
    struct Flux {
        double value, slopeA, slopeB;
    };
    // Positions of the entries of an edge in the matrix.
    struct Entries {
        int aa, ab, ba, bb;
    };

    bool tryStep(double dt, std::vector<double>& poreMass);
    Flux flux(const Edge& edge) const;
    void findFluxes();
    double assemble(double dt, const std::vector<double>& poreMass);
    void applyFluxes(double dt, std::vector<double>& poreMass) const;

    BrooksCorey curve_;
    double fluxScale_;
    std::vector<Edge> edges_;
    std::vector<double> capacities_;
    std::vector<double> rise_;  // for each edge, rho g (z_a - z_b), Pa
    double lowerFraction_ = 0.5;

    std::vector<Flux> fluxes_;
    Eigen::VectorXd saturation_;
    Eigen::VectorXd residual_;
    Eigen::SparseMatrix<double, Eigen::RowMajor> matrix_;
    std::vector<int> diagonal_;
    std::vector<Entries> entries_;
    Eigen::BiCGSTAB<Eigen::SparseMatrix<double, Eigen::RowMajor>> solver_;
};

}  // namespace drench
