// Mass, stiffness, adhesion, drag and colour of wet cloth, as functions of its water. Independent of Bullet.
#pragma once

#include <array>

#include "drench/config.h"
#include "drench/fabric.h"

namespace drench {

/// Linear RGB reflectance, each 0 to 1.
using Colour = std::array<double, 3>;

/// Air drag of a face: pressure 1/2 rho C_n u_n^2 normal to it, shear stress 1/2 rho C_t u_t^2 along it.
struct AirDrag {
    double normal;        ///< C_n, dimensionless; 1.2, as for a plate normal to the flow (assumed)
    double tangential;    ///< C_t, dimensionless; 0.03, as for a rough surface (assumed)
    double permeability;  ///< speed of the air through the cloth over pressure, m/(s Pa)
};

/// Properties of one fabric as functions of its water, to be evaluated for each node.
class DRENCH_API WetLaws {
  public:
    /// @throws std::invalid_argument for a fabric that `validate` refuses
    explicit WetLaws(const Fabric& fabric);

    /// Mass of wet cloth, kg: area x areal density + water.
    /// @param area   of the cloth, m2
    /// @param water  in and on it, kg
    double mass(double area, double water) const { return area * arealDensity_ + water; }

    /// Softening of the fibre by bound water, 0 to 1: moisture content over the bound maximum, at most 1.
    /// @param moistureContent  kg of water per kg of dry cloth
    double softening(double moistureContent) const;

    /// Stretch and shear stiffness over the dry value, dimensionless: 1 + (wet ratio - 1) softening.
    double stretchRatio(double moistureContent) const { return ratio(wetStretchRatio_, moistureContent); }
    /// Bending rigidity over the dry value, dimensionless; the same formula.
    double bendingRatio(double moistureContent) const { return ratio(wetBendingRatio_, moistureContent); }
    /// Bending friction over the dry value, dimensionless; the same formula.
    double bendingFrictionRatio(double moistureContent) const {
        return ratio(wetBendingFrictionRatio_, moistureContent);
    }

    /// Energy to peel the cloth off a wettable surface or another wet cloth, J/m2: `Fabric::clingEnergy` times a
    /// factor for the saturation and a factor for the film (both assumed, linear in between). The first is 0 up to the
    /// bound maximum and 1 from a pore saturation of 0.3 on. The second is 1 up to a film of 0.1 mm and 0 from 0.2 mm
    /// on, where the film drains.
    /// @param saturation     of the pores, 0 to 1
    /// @param filmThickness  on one face, m
    double clingEnergy(double saturation, double filmThickness) const;

    /// Air drag at a pore saturation of 0 to 1. The permeability falls linearly with the saturation (shape measured).
    AirDrag drag(double saturation) const;

    /// Diffuse colour at a pore saturation of 0 to 1.
    ///
    /// The wet colour is A / (n^2 (1 - A) + A), n = 1.33 (Angstrom 1925): 0.4 becomes 0.27. In between, the
    /// Kubelka-Munk ratio K/S = (1 - A)^2 / (2 A) is interpolated linearly: nine tenths of the change up to 60 %
    /// saturation (measured), the last tenth from there to full pores (assumed).
    Colour albedo(double saturation) const;

    /// Fraction of light that the cloth transmits at a pore saturation of 0 to 1: T = 1 / (1 + S h), a thin layer
    /// without absorption (Kubelka and Munk 1931), with S h the scattering power. Full pores divide S h by
    /// `Fabric::scatteringLoss`; in between 1 / (S h) is interpolated as in `albedo`.
    double transmittance(double saturation) const;

    /// Fraction of the face that is glossy like water, 0 to 1: film thickness over 18 um, the retained film (assumed).
    /// @param filmThickness  on one face, m
    static double gloss(double filmThickness);

  private:
    double ratio(double wetRatio, double moistureContent) const {
        return 1 + (wetRatio - 1) * softening(moistureContent);
    }

    double arealDensity_;
    double boundMaximum_;
    double wetStretchRatio_;
    double wetBendingRatio_;
    double wetBendingFrictionRatio_;
    double clingEnergy_;                   // J/m2
    double bindingSaturation_;             // of the pores, at the bound maximum
    double airPermeabilityDry_;            // m/(s Pa)
    double airPermeabilitySaturated_;      // m/(s Pa)
    std::array<double, 3> absorptionDry_;  // K/S
    std::array<double, 3> absorptionWet_;  // K/S
    double clearnessDry_;                  // 1 / (S h)
    double clearnessWet_;                  // 1 / (S h)
};

}  // namespace drench
