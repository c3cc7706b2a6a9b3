// What water does to cloth: from the content of a node to its mass, stiffness, drag and colour.
// Pure functions of a fabric; knows nothing of Bullet.
#pragma once

#include <array>

#include "drench/export.h"
#include "drench/fabric.h"

namespace drench {

/// Linear RGB reflectance, each 0 to 1.
using Colour = std::array<double, 3>;

/// How a face of the cloth takes the air: pressure 1/2 rho C_n u_n^2 across it, shear stress 1/2 rho C_t
/// u_t^2 along it.
struct AirDrag {
    double normal;        ///< C_n, 1; 1.2 (assumed: a plate across the flow)
    double tangential;    ///< C_t, 1; 0.03 (assumed: rough skin friction)
    double permeability;  ///< air speed through the cloth per pressure, m/(s Pa)
};

/// The laws of one fabric, ready to evaluate for each node.
class DRENCH_API WetLaws {
  public:
    /// @throws std::invalid_argument for a fabric out of range.
    explicit WetLaws(const Fabric& fabric);

    /// Mass of `area` m2 of cloth with `water` kg in and on it, kg: area x areal density + water.
    double mass(double area, double water) const { return area * arealDensity_ + water; }

    /// How far bound water has softened the fibre, 0 to 1: content over the bound maximum, at most 1.
    /// @param content  water over dry cloth, kg/kg
    double softening(double content) const;

    /// Stiffness of stretch and shear over dry, 1: 1 + (wet ratio - 1) softening. Continuous in the content.
    double stretchRatio(double content) const { return ratio(wetStretchRatio_, content); }
    /// Bending rigidity over dry, 1.
    double bendingRatio(double content) const { return ratio(wetBendingRatio_, content); }
    /// Bending friction over dry, 1.
    double bendingFrictionRatio(double content) const { return ratio(wetBendingFrictionRatio_, content); }

    /// Energy that it takes to peel the cloth off a wettable surface, or off another wet cloth, J/m2. None up to the
    /// bound maximum, all of `Fabric::clingEnergy` from a pore saturation of 0.3 on (at most; assumed), while a
    /// film on the face of up to 0.1 mm bridges the gap; none any more from 0.2 mm on, where it drains instead
    /// (assumed). Linear in between.
    /// @param saturation     of the pores, 0 to 1
    /// @param filmThickness  on one face, m
    double clingEnergy(double saturation, double filmThickness) const;

    /// Drag at a pore saturation of 0 to 1; water closes the pores linearly (measured in shape).
    AirDrag drag(double saturation) const;

    /// Diffuse colour at a pore saturation of 0 to 1.
    ///
    /// Dry and wet colour mix linearly in the Kubelka-Munk ratio K/S = (1 - A)^2 / (2 A). Nine tenths of the
    /// way are done at 60 % saturation (linear up to there: measured), the last tenth from there to full
    /// pores (assumed). The wet colour is A / (n^2 (1 - A) + A), n = 1.33 (Angstrom 1925): 0.4 becomes 0.27.
    Colour albedo(double saturation) const;

    /// Share of the light that passes the cloth at a pore saturation of 0 to 1: T = 1 / (1 + S h), the thin layer of
    /// Kubelka and Munk (1931) without absorption, S h the scattering power. Water divides it by
    /// `Fabric::scatteringLoss`; in between 1 / (S h) mixes as the colour does.
    double transmittance(double saturation) const;

    /// How much of the face shines like water, 0 to 1: film thickness over the 18 um that a face retains (assumed).
    /// @param filmThickness  on one face, m
    static double gloss(double filmThickness);

  private:
    double ratio(double wetRatio, double content) const { return 1 + (wetRatio - 1) * softening(content); }

    double arealDensity_;
    double boundMaximum_;
    double wetStretchRatio_;
    double wetBendingRatio_;
    double wetBendingFrictionRatio_;
    double clingEnergy_;                   // J/m2
    double bindingSaturation_;             // of the pores, with the bound maximum in them
    double airPermeabilityDry_;            // m/(s Pa)
    double airPermeabilitySaturated_;      // m/(s Pa)
    std::array<double, 3> absorptionDry_;  // K/S
    std::array<double, 3> absorptionWet_;  // K/S
    double clearnessDry_;                  // 1 / (S h)
    double clearnessWet_;                  // 1 / (S h)
};

}  // namespace drench
