#include "water/layer_wicking.h"

#include <algorithm>
#include <cmath>

#include "drench/water.h"

namespace drench {

namespace {

// Time in which film leaves a face that is covered, s (assumed; through full pores a pressure of 1 kPa drives a film of
// 0.1 mm through cloth within a tenth of that).
constexpr double filmTime = 0.1;

constexpr int maxLayerSteps = 16;

// The suction at which layers with pores of unlike distribution meet is found in so many halvings.
constexpr int halvings = 50;

// Solves m = times x flux(m) for a flux that falls with m. @param most  upper bound of m
template <typename Flux>
double implicitMass(double times, double most, double fluxAtNone, Flux flux) {
    double low = 0, high = most;
    double below = -times * fluxAtNone, above = high - times * flux(high);
    if (!(above > 0)) return high;
    // Regula falsi; halving the value of an end that stays makes it converge from both sides (Illinois).
    constexpr int iterations = 12;
    constexpr double ofMost = 1e-6;  // tolerance
    int stays = 0;
    for (int i = 0; i < iterations && high - low > ofMost * most; ++i) {
        const double m = std::clamp((low * above - high * below) / (above - below), low, high);
        const double value = m - times * flux(m);
        if (std::abs(value) <= ofMost * most) return m;
        if (value < 0) {
            low = m;
            below = value;
            if (stays < 0) above /= 2;
            stays = -1;
        } else {
            high = m;
            above = value;
            if (stays > 0) below /= 2;
            stays = 1;
        }
    }
    return low;  // the lower end never moves too much
}

}  // namespace

LayerLaw::LayerLaw(const Fabric& fabric)
    : curve_(fabric),
      index_(fabric.poreSizeIndex),
      fullFlux_(waterDensity * fabric.permeabilityThrough / waterViscosity * curve_.psiScale() /
                (fabric.thickness / 2)),
      capacity_(fabric.poreCapacity()),
      percolation_(waterDensity * waterDensity * fabric.permeabilityThrough / waterViscosity) {}

double LayerLaw::flux(double s) const {
    if (curve_.isSimple()) return fullFlux_ * (s * s) * (s * s);
    return fullFlux_ * std::pow(s, curve_.psiExponent());
}

double LayerLaw::fluxAtSuction(double suction) const {
    return suction <= entryPressure() ? fullFlux_
                                      : fullFlux_ * std::pow(entryPressure() / suction, 3 * index_ + 1);
}

double LayerLaw::suction(double s) const {
    constexpr double driest = 1e-4;
    return entryPressure() * std::pow(std::max(s, driest), -1 / index_);
}

double LayerLaw::rate(double s) const {
    return fullFlux_ * curve_.psiExponent() * std::pow(s, curve_.psiExponent() - 1) / capacity_;
}

bool LayerLaw::operator==(const LayerLaw& other) const {
    return fullFlux_ == other.fullFlux_ && index_ == other.index_ && entryPressure() == other.entryPressure();
}

LayerWicking::LayerWicking(const LayerLaw& one, const LayerLaw& other)
    : one_(one), other_(other), areAlike_(one == other), haveSameIndex_(one.index() == other.index()) {
    const double exponent = 3 * one.index() + 1, ratio = other.entryPressure() / one.entryPressure();
    otherScale_ = other.fullFlux() * std::pow(ratio, exponent);
    otherMost_ = std::pow(ratio, -exponent);
}

// The flux of each layer is its full flux times the potential (p_b / p)^(3 L + 1) at its suction p, and at the face minus
// that at the suction there. So with one L the potential at the face is the mean of both, weighted by their full fluxes,
// unless one of them is full there.
double LayerWicking::flux(double s, double sOfOther) const {
    const double here = one_.flux(s), there = other_.flux(sOfOther);
    if (areAlike_) return (here - there) / 2;
    if (!haveSameIndex_) return here - fluxAtFace(s, sOfOther, here + there);
    const double potential = (here + there) / (one_.fullFlux() + otherScale_);
    if (potential > 1) return here - one_.fullFlux();
    if (potential > otherMost_) return other_.fullFlux() - there;
    return here - one_.fullFlux() * potential;
}

// The part of the sum of both fluxes that is the first layer's at the suction of the face.
double LayerWicking::fluxAtFace(double s, double sOfOther, double sum) const {
    double low = std::log(std::min(one_.entryPressure(), other_.entryPressure()));
    double high = std::log(std::max(one_.suction(s), other_.suction(sOfOther)));
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2, suction = std::exp(middle);
        (one_.fluxAtSuction(suction) + other_.fluxAtSuction(suction) > sum ? low : high) = middle;
    }
    return one_.fluxAtSuction(std::exp(low));
}

void LayerWicking::step(double dt, const std::vector<LayerPair>& pairs, const Store& one,
                        const Store& other) const {
    if (!(dt > 0) || pairs.empty()) return;
    const int steps = stepsFor(dt, pairs, one, other);
    if (steps == 0) return;
    const auto move = [&](const LayerPair& pair) {
        movePair(dt / steps * pair.area, one.poreMass[pair.node], one.capacities[pair.node],
                 other.poreMass[pair.other], other.capacities[pair.other]);
    };
    for (int i = 0; i < steps; ++i) {
        if (i % 2 == 0)
            std::for_each(pairs.begin(), pairs.end(), move);
        else
            std::for_each(pairs.rbegin(), pairs.rend(), move);
    }
}

// 0 if all are dry.
int LayerWicking::stepsFor(double dt, const std::vector<LayerPair>& pairs, const Store& one,
                           const Store& other) const {
    double wettest = 0, wettestOther = 0;
    for (const LayerPair& pair : pairs) {
        wettest = std::max(wettest, one.poreMass[pair.node] / one.capacities[pair.node]);
        wettestOther = std::max(wettestOther, other.poreMass[pair.other] / other.capacities[pair.other]);
    }
    if (!(wettest > 0 || wettestOther > 0)) return 0;
    constexpr double perStep = 0.5;  // of the time in which the wettest pores empty
    const double rate = std::max(one_.rate(std::min(wettest, 1.0)), other_.rate(std::min(wettestOther, 1.0)));
    return static_cast<int>(std::clamp(std::ceil(dt * rate / perStep), 1.0, double(maxLayerSteps)));
}

// @param times  area times time, m2 s
void LayerWicking::movePair(double times, double& mass, double capacity, double& massOfOther,
                            double capacityOfOther) const {
    const double s = std::min(mass / capacity, 1.0), sOfOther = std::min(massOfOther / capacityOfOther, 1.0);
    if (areAlike_ && s == sOfOther) return;
    const double now = flux(s, sOfOther), sign = now < 0 ? -1 : 1;
    const double there = now < 0 ? massOfOther : mass;
    const double room = now < 0 ? capacity - mass : capacityOfOther - massOfOther;
    const double most = std::min({times * std::abs(now), there, std::max(room, 0.0)});
    if (!(most > 0)) return;
    const double moved = sign * implicitMass(times, most, std::abs(now), [&](double m) {
                             return sign * flux(std::max(s - sign * m / capacity, 0.0),
                                                std::max(sOfOther + sign * m / capacityOfOther, 0.0));
                         });
    mass -= moved;
    massOfOther += moved;
}

const std::vector<double>& LayerFilm::leaving(double dt, double gravity, const std::vector<LayerPair>& pairs,
                                              bool isWithin, const Moisture& donor) {
    const std::vector<double>& film = donor.filmMass();
    leaving_.assign(pairs.size() * (isWithin ? 2 : 1), 0.0);
    areas_.assign(donor.size(), 0.0);
    left_ = film;
    for (const LayerPair& pair : pairs) {
        areas_[pair.node] += pair.area;
        if (isWithin) areas_[pair.other] += pair.area;
    }
    const double fraction = -std::expm1(-dt / filmTime), percolation = dt * law_.percolation(gravity);
    constexpr double full = 0.999;
    for (std::size_t i = 0; i < leaving_.size(); ++i) {
        const bool isReversed = i >= pairs.size();
        const LayerPair& pair = pairs[isReversed ? i - pairs.size() : i];
        const std::size_t node = isReversed ? pair.other : pair.node;
        if (!(left_[node] > 0)) continue;
        const double descent = isReversed ? -pair.descent : pair.descent;
        // What is open of one face is enough for film to stay.
        const double covered = std::max(1 - 2 * donor.openFraction(node), 0.0);
        double mass = film[node] * fraction * covered * pair.area / areas_[node];
        if (descent > 0 && donor.saturation(node) > full) mass += percolation * descent * pair.area;
        leaving_[i] = std::min(mass, left_[node]);
        left_[node] -= leaving_[i];
    }
    return leaving_;
}

void LayerFilm::pass(double dt, double gravity, const std::vector<LayerPair>& pairs, const Moisture& layer,
                     std::vector<double>& filmMass) {
    leaving(dt, gravity, pairs, true, layer);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const double passed = leaving_[i] - leaving_[i + pairs.size()];
        filmMass[pairs[i].node] -= passed;
        filmMass[pairs[i].other] += passed;
    }
    // What is left of a film that leaves through several pairs may be less than nothing by rounding.
    for (const LayerPair& pair : pairs)
        for (const std::size_t node : {pair.node, pair.other}) filmMass[node] = std::max(filmMass[node], 0.0);
}

}  // namespace drench
