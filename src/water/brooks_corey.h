// Suction and conductivity of partly filled pores.
#pragma once

#include <cmath>

#include "drench/fabric.h"

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

}  // namespace drench
