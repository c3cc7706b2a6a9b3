// Water that passes between layers of cloth that touch.
#pragma once

#include <cstddef>
#include <vector>

#include "drench/fabric.h"
#include "drench/moisture.h"
#include "water/brooks_corey.h"

namespace drench {

// How water moves within one layer, from its middle to a face. By Darcy's law (1856) for the permeability k through the
// cloth over half its thickness h / 2, the flux between a saturation s in the middle and a dry face is
// (rho k / mu) Psi(s) / (h / 2), kg/(m2 s), with Psi as in BrooksCorey.
class LayerLaw {
  public:
    explicit LayerLaw(const Fabric& fabric);

    double flux(double s) const;
    double fullFlux() const { return fullFlux_; }
    double entryPressure() const { return curve_.entryPressure(); }
    double index() const { return index_; }
    // The flux at the saturation that a suction leaves, Pa.
    double fluxAtSuction(double suction) const;
    double suction(double s) const;
    bool operator==(const LayerLaw& other) const;
    // How fast full pores of a layer empty through a face, 1/s: slope of the flux over their capacity.
    double rate(double s) const;
    // Percolation through full pores by gravity, kg/(m2 s).
    double percolation(double gravity) const { return percolation_ * gravity; }

  private:
    BrooksCorey curve_;
    double index_;
    double fullFlux_;     // kg/(m2 s)
    double capacity_;     // of the pores, kg/m2
    double percolation_;  // over gravity, kg s/m3
};

// Two layers that touch. Where they do, suctions are equal, and what leaves one enters the other. For two layers of the
// same fabric this is q = (rho k / mu) (Psi(s_a) - Psi(s_b)) / h. At rest both have the same suction: layers of the same
// fabric the same saturation, and of others the one with the finer pores more.
class LayerWicking {
  public:
    LayerWicking(const LayerLaw& one, const LayerLaw& other);

    // From a layer with saturation s to the other one, kg/(m2 s).
    double flux(double s, double sOfOther) const;

    // The water of the nodes of a layer. Both may be the same.
    struct Store {
        const double* capacities;  // of the pores, kg
        double* poreMass;          // kg
    };
    // Moves pore water for `dt` seconds, pair by pair, each by an implicit step (backward Euler), there and back: stable at
    // any length. No pore gets more than it holds, or less than nothing.
    void step(double dt, const std::vector<LayerPair>& pairs, const Store& one, const Store& other) const;

  private:
    void movePair(double times, double& mass, double capacity, double& massOfOther,
                  double capacityOfOther) const;
    double fluxAtFace(double s, double sOfOther, double sum) const;
    int stepsFor(double dt, const std::vector<LayerPair>& pairs, const Store& one, const Store& other) const;

    LayerLaw one_, other_;
    bool areAlike_, haveSameIndex_;
    double
        otherScale_;  // full flux of the other times the ratio of both entry pressures to the power of the potential
    double otherMost_;  // potential at which the other is full, if it is 1 where the first is
};

// Film that leaves a layer through faces that touch it: out of those that are covered, and by gravity down through full
// pores.
class LayerFilm {
  public:
    explicit LayerFilm(const Fabric& fabric) : law_(fabric) {}

    // Film that leaves the first node of each pair, kg.
    // @param isWithin  whether both nodes are of the donor: then followed by what leaves the second node of each
    const std::vector<double>& leaving(double dt, double gravity, const std::vector<LayerPair>& pairs,
                                       bool isWithin, const Moisture& donor);
    // The same within one layer, to which it is applied.
    void pass(double dt, double gravity, const std::vector<LayerPair>& pairs, const Moisture& layer,
              std::vector<double>& filmMass);

  private:
    LayerLaw law_;
    std::vector<double> areas_;    // of the pairs of each node, m2
    std::vector<double> left_;     // of the film of each node, kg
    std::vector<double> leaving_;  // kg
};

}  // namespace drench
