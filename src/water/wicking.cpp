#include "water/wicking.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drench/water.h"
#include "water/implicit_wicking.h"

namespace drench {

namespace {

// Weight of the lower node in the permeability to gravity.
double lowerFraction(const BrooksCorey& curve, double gravity, double longestEdge) {
    const double weight = waterDensity * gravity * longestEdge * EdgeRuns::allowedStretch;
    const double steepest = curve.permeabilitySlope(1) / curve.psiSlope(1);  // (3 L + 2) / p_b
    return weight * steepest > 2 ? 1 / (weight * steepest) : 0.5;
}

}  // namespace

Wicking::Wicking(const Fabric& fabric, const ClothMesh& mesh)
    : Wicking(fabric, mesh, conductances(mesh, fabric.permeabilityWarp, fabric.permeabilityWeft)) {}

Wicking::Wicking(const Fabric& fabric, const ClothMesh& mesh, const std::vector<Edge>& edges)
    : curve_(fabric),
      fluxScale_(waterDensity * fabric.thickness / waterViscosity),
      runs_(edges),
      psi_(mesh.size()),
      permeability_(mesh.size()) {
    for (const double area : mesh.areas)
        inverseCapacities_.push_back(area > 0 ? static_cast<float>(1 / (area * fabric.poreCapacity()))
                                              : 0.0f);
    std::vector<double> conductance(mesh.size()), conductanceLength(mesh.size());
    for (const Edge& edge : edges) {
        longestEdge_ = std::max(longestEdge_, edge.length);
        for (const int node : {edge.a, edge.b}) {
            conductance[static_cast<std::size_t>(node)] += edge.conductance;
            conductanceLength[static_cast<std::size_t>(node)] += edge.conductance * edge.length;
        }
    }
    for (std::size_t n = 0; n < mesh.size(); ++n) {
        const double inverseCapacity = double(inverseCapacities_[n]);
        largestPsiRate_ = std::max(largestPsiRate_, conductance[n] * inverseCapacity);
        largestGravityRate_ = std::max(largestGravityRate_, conductanceLength[n] * inverseCapacity);
    }
}

Wicking::~Wicking() = default;
Wicking::Wicking(Wicking&&) noexcept = default;
Wicking& Wicking::operator=(Wicking&&) noexcept = default;

std::size_t Wicking::bytes() const {
    return runs_.bytes() + psi_.size() * 3 * sizeof(float);  // inverse capacities, psi, permeability
}

// Pores that are nearly closed count as a tenth of what they were, so that steps need not be shorter than by that.
void Wicking::setCapacity(std::size_t node, double capacity, double whole) {
    constexpr double least = 0.1;
    const double counts = std::max(capacity, least * whole);
    inverseCapacities_[node] = static_cast<float>(1 / counts);
    pressedRate_ = capacity < whole ? std::max(pressedRate_, whole / counts) : 1;
    if (implicit_) implicit_->setCapacity(node, counts);
}

double Wicking::explicitBound(double gravity) const {
    const double rate = fluxScale_ * (largestPsiRate_ * curve_.psiSlope(1) +
                                      largestGravityRate_ * EdgeRuns::allowedStretch * waterDensity *
                                          gravity * curve_.permeabilitySlope(1));
    return rate > 0 ? 1 / (rate * pressedRate_) : std::numeric_limits<double>::infinity();
}

void Wicking::step(double dt, const std::vector<float>& heights, double gravity,
                   const std::vector<double>& capacities, std::vector<double>& poreMass) {
    if (runs_.empty() || !(dt > 0)) return;
    const double steps = std::max(1.0, std::ceil(dt / explicitBound(gravity)));
    if (steps > maxExplicitSteps) {
        if (!implicit_)
            implicit_ = std::make_unique<ImplicitWicking>(curve_, fluxScale_, runs_.edges(), capacities);
        implicit_->step(dt, heights, waterDensity * gravity, lowerFraction(curve_, gravity, longestEdge_),
                        poreMass);
        return;
    }
    for (int i = 0; i < static_cast<int>(steps); ++i)
        explicitStep(dt / steps, heights.data(), gravity, poreMass.data());
}

void Wicking::evaluate(const double* poreMass, double psiFactor) {
    const std::size_t nodes = psi_.size();
    const float* inverseCapacity = inverseCapacities_.data();
    float* psi = psi_.data();
    float* permeability = permeability_.data();
    const float factor = static_cast<float>(psiFactor);
    if (curve_.isSimple()) {
#pragma omp simd
        for (std::size_t n = 0; n < nodes; ++n) {
            const float s = std::clamp(static_cast<float>(poreMass[n]) * inverseCapacity[n], 0.0f, 1.0f);
            const float s4 = s * s * s * s;
            psi[n] = factor * s4;
            permeability[n] = s4 * s;
        }
        return;
    }
    const float psiExponent = static_cast<float>(curve_.psiExponent());
    const float permeabilityExponent = static_cast<float>(curve_.permeabilityExponent());
    for (std::size_t n = 0; n < nodes; ++n) {
        const float s = std::clamp(static_cast<float>(poreMass[n]) * inverseCapacity[n], 0.0f, 1.0f);
        psi[n] = factor * std::pow(s, psiExponent);
        permeability[n] = std::pow(s, permeabilityExponent);
    }
}

void Wicking::explicitStep(double dt, const float* heights, double gravity, double* poreMass) {
    evaluate(poreMass, dt * fluxScale_ * curve_.psiScale());
    const float weight = static_cast<float>(dt * fluxScale_ * waterDensity * gravity);
    const float fraction = static_cast<float>(lowerFraction(curve_, gravity, longestEdge_));
    const float *psi = psi_.data(), *permeability = permeability_.data();
    runs_.move(poreMass, [=](std::size_t a, std::size_t b, float conductance, float steepest) {
        const float rise = std::min(std::max(heights[a] - heights[b], -steepest), steepest);
        const float fractionA = rise > 0 ? 1 - fraction : fraction;
        const float mean = permeability[b] + fractionA * (permeability[a] - permeability[b]);
        return conductance * (psi[a] - psi[b] + weight * mean * rise);
    });
}

}  // namespace drench
