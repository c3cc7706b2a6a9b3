#include "water/implicit_wicking.h"

#include <algorithm>
#include <cmath>

#include "water/edge_runs.h"

namespace drench {

namespace {

constexpr int maxIterations = 40;
constexpr double tolerance = 1e-12;  // of a node's capacity
constexpr int maxPieces = 4096;      // into which a step is divided

// Index of an entry within the values of a matrix.
int indexOf(const Eigen::SparseMatrix<double, Eigen::RowMajor>& matrix, int row, int column) {
    const int* begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[row];
    const int* end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[row + 1];
    return static_cast<int>(std::lower_bound(begin, end, column) - matrix.innerIndexPtr());
}

}  // namespace

ImplicitWicking::ImplicitWicking(const BrooksCorey& curve, double fluxScale, const std::vector<Edge>& edges,
                                 const std::vector<double>& capacities)
    : curve_(curve), fluxScale_(fluxScale), edges_(edges), capacities_(capacities), fluxes_(edges.size()) {
    const auto nodes = static_cast<Eigen::Index>(capacities.size());
    saturation_.resize(nodes);
    residual_.resize(nodes);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(capacities.size() + 2 * edges.size());
    for (int n = 0; n < nodes; ++n) entries.emplace_back(n, n, 1.0);
    for (const Edge& edge : edges_) {
        entries.emplace_back(edge.a, edge.b, 1.0);
        entries.emplace_back(edge.b, edge.a, 1.0);
    }
    matrix_.resize(nodes, nodes);
    matrix_.setFromTriplets(entries.begin(), entries.end());
    for (int n = 0; n < nodes; ++n) diagonal_.push_back(indexOf(matrix_, n, n));
    for (const Edge& edge : edges_)
        entries_.push_back({indexOf(matrix_, edge.a, edge.a), indexOf(matrix_, edge.a, edge.b),
                            indexOf(matrix_, edge.b, edge.a), indexOf(matrix_, edge.b, edge.b)});
    solver_.setTolerance(1e-6);
    solver_.setMaxIterations(500);
}

void ImplicitWicking::step(double dt, const std::vector<float>& heights, double weight, double lowerFraction,
                           std::vector<double>& poreMass) {
    lowerFraction_ = lowerFraction;
    rise_.clear();
    for (const Edge& edge : edges_) {
        const double rise = double(heights[static_cast<std::size_t>(edge.a)]) -
                            double(heights[static_cast<std::size_t>(edge.b)]);
        const double steepest = EdgeRuns::allowedStretch * edge.length;
        rise_.push_back(weight * std::clamp(rise, -steepest, steepest));
    }
    // Pieces are counted in units of the smallest one, so that they add up to the step.
    int done = 0, piece = maxPieces;
    while (done < maxPieces) {
        if (tryStep(dt * piece / maxPieces, poreMass)) {
            done += piece;
            piece = std::min(2 * piece, maxPieces - done);
        } else if (piece > 1) {
            piece /= 2;
        } else {
            done += piece;  // in a piece without a solution nothing moves
        }
    }
}

bool ImplicitWicking::tryStep(double dt, std::vector<double>& poreMass) {
    for (std::size_t n = 0; n < capacities_.size(); ++n)
        saturation_[Eigen::Index(n)] = capacities_[n] > 0 ? poreMass[n] / capacities_[n] : 0.0;
    for (int iteration = 0; iteration < maxIterations; ++iteration) {
        findFluxes();
        if (assemble(dt, poreMass) < tolerance) {
            applyFluxes(dt, poreMass);
            return true;
        }
        solver_.compute(matrix_);
        const Eigen::VectorXd change = solver_.solve(residual_);
        if (!change.allFinite()) return false;
        saturation_ = (saturation_ - change).cwiseMax(0.0);
    }
    return false;
}

ImplicitWicking::Flux ImplicitWicking::flux(const Edge& edge) const {
    const double a = std::min(saturation_[edge.a], 1.0), b = std::min(saturation_[edge.b], 1.0);
    const double rise = rise_[static_cast<std::size_t>(&edge - edges_.data())];
    const double fractionA = rise > 0 ? 1 - lowerFraction_ : lowerFraction_, fractionB = 1 - fractionA;
    const double scale = fluxScale_ * edge.conductance;
    const double value = curve_.psi(a) - curve_.psi(b) +
                         rise * (fractionA * curve_.permeability(a) + fractionB * curve_.permeability(b));
    // Beyond full pores neither suction nor permeability increases.
    const double slopeA =
        saturation_[edge.a] > 1 ? 0.0 : curve_.psiSlope(a) + rise * fractionA * curve_.permeabilitySlope(a);
    const double slopeB =
        saturation_[edge.b] > 1 ? 0.0 : -curve_.psiSlope(b) + rise * fractionB * curve_.permeabilitySlope(b);
    return {scale * value, scale * slopeA, scale * slopeB};
}

void ImplicitWicking::findFluxes() {
    for (std::size_t e = 0; e < edges_.size(); ++e) fluxes_[e] = flux(edges_[e]);
}

// Computes residual and matrix. @return the largest residual over the capacity of its node
double ImplicitWicking::assemble(double dt, const std::vector<double>& poreMass) {
    double* values = matrix_.valuePtr();
    std::fill(values, values + matrix_.nonZeros(), 0.0);
    for (std::size_t n = 0; n < capacities_.size(); ++n) {
        const bool cloth = capacities_[n] > 0;
        values[diagonal_[n]] = cloth ? capacities_[n] : 1.0;
        residual_[Eigen::Index(n)] =
            cloth ? capacities_[n] * saturation_[Eigen::Index(n)] - poreMass[n] : 0.0;
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        const Flux& flux = fluxes_[e];
        residual_[edges_[e].a] += dt * flux.value;
        residual_[edges_[e].b] -= dt * flux.value;
        values[entries_[e].aa] += dt * flux.slopeA;
        values[entries_[e].ab] += dt * flux.slopeB;
        values[entries_[e].ba] -= dt * flux.slopeA;
        values[entries_[e].bb] -= dt * flux.slopeB;
    }
    double largest = 0;
    for (std::size_t n = 0; n < capacities_.size(); ++n)
        if (capacities_[n] > 0)
            largest = std::max(largest, std::abs(residual_[Eigen::Index(n)]) / capacities_[n]);
    return largest;
}

// Applies the fluxes rather than the computed saturations, which have rounding errors. So no water is created
// or lost, except where rounding has made a node's water slightly negative.
void ImplicitWicking::applyFluxes(double dt, std::vector<double>& poreMass) const {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        poreMass[static_cast<std::size_t>(edges_[e].a)] -= dt * fluxes_[e].value;
        poreMass[static_cast<std::size_t>(edges_[e].b)] += dt * fluxes_[e].value;
    }
    for (double& mass : poreMass) mass = std::max(mass, 0.0);
}

}  // namespace drench
