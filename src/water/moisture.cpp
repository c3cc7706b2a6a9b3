#include "drench/moisture.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "drench/water.h"

namespace drench {

Moisture::Moisture(const Fabric& fabric, std::vector<double> areas)
    : arealDensity_(fabric.arealDensity),
      wettingTime_(fabric.wettingTime),
      areas_(std::move(areas)),
      poreMass_(areas_.size(), 0.0),
      filmMass_(areas_.size(), 0.0) {
    validate(fabric);
    poreCapacities_.reserve(areas_.size());
    for (std::size_t node = 0; node < areas_.size(); ++node) {
        if (!(areas_[node] >= 0) || !std::isfinite(areas_[node]))
            throw std::invalid_argument("drench: node " + std::to_string(node) + " has an area of " +
                                        std::to_string(areas_[node]) +
                                        " m2; give a third of its rest triangles, at least 0");
        poreCapacities_.push_back(areas_[node] * fabric.poreCapacity());
    }
}

void Moisture::addFilm(std::size_t node, double mass) {
    if (node >= size())
        throw std::out_of_range("drench: node " + std::to_string(node) + " of a sheet with " +
                                std::to_string(size()) + " nodes; give 0 to " + std::to_string(size() - 1));
    constexpr double most = 1e6;  // keeps sums finite in single-precision Bullet
    if (!(mass >= 0 && mass <= most))
        throw std::invalid_argument("drench: " + std::to_string(mass) + " kg of water for node " +
                                    std::to_string(node) + "; give a mass from 0 to 1e6 kg");
    if (areas_[node] == 0)
        throw std::invalid_argument("drench: node " + std::to_string(node) +
                                    " belongs to no triangle and has no cloth to wet");
    filmMass_[node] += mass;
    supplied_ += mass;
}

void Moisture::step(double dt) {
    if (!(dt >= 0) || !std::isfinite(dt))
        throw std::invalid_argument("drench: a water step of " + std::to_string(dt) +
                                    " s; give a finite time of at least 0 s");
    // The exponential approach to saturation of physics' absorption law, and of AATCC 79's drop test.
    const double share = -std::expm1(-dt / wettingTime_);
    for (std::size_t node = 0; node < size(); ++node) {
        const double missing = poreCapacities_[node] - poreMass_[node];
        const double absorbed = std::min(filmMass_[node], missing * share);
        poreMass_[node] += absorbed;
        filmMass_[node] -= absorbed;
    }
}

double Moisture::saturation(std::size_t node) const {
    return poreCapacities_[node] > 0 ? poreMass_[node] / poreCapacities_[node] : 0.0;
}

double Moisture::content(std::size_t node) const {
    return areas_[node] > 0 ? (poreMass_[node] + filmMass_[node]) / (areas_[node] * arealDensity_) : 0.0;
}

double Moisture::filmThickness(std::size_t node) const {
    return areas_[node] > 0 ? filmMass_[node] / (2 * waterDensity * areas_[node]) : 0.0;
}

double Moisture::totalPoreMass() const {
    return std::accumulate(poreMass_.begin(), poreMass_.end(), 0.0);
}

double Moisture::totalFilmMass() const {
    return std::accumulate(filmMass_.begin(), filmMass_.end(), 0.0);
}

Ledger Moisture::ledger() const {
    Ledger ledger;
    ledger.supplied = supplied_;
    ledger.held = totalPoreMass() + totalFilmMass();
    return ledger;
}

}  // namespace drench
