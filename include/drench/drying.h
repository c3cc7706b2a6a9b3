// Evaporation from wet cloth, and the equilibrium between cloth and humid air.
#pragma once

#include "drench/air.h"
#include "drench/config.h"
#include "drench/fabric.h"

namespace drench {

/// Evaporation from a sheet that is wet on both faces.
struct Evaporation {
    double rate;                ///< of both faces together, kg/s per m2 of cloth; at least 0
    double surfaceTemperature;  ///< of the wet cloth, degrees Celsius; close to the wet-bulb temperature
    double heatTransfer;        ///< convective heat transfer coefficient h_c, W/(m2 K)
};

/// Checks the ranges of all members of `Air`.
/// @throws std::invalid_argument that names the value and its range
DRENCH_API void validate(const Air& air);

/// Evaporation from a sheet that is wet on both faces (textbook):
/// - rate = 2 h_m (rho_sat(T_s) - RH rho_sat(T_a)), times `Air::vapourExchange`;
/// - mass transfer coefficient h_m = h_c / (rho_a c_p) Le^(-2/3), Le = 0.85 (Chilton & Colburn 1934);
/// - h_c of a flat plate: Nu = 0.664 Re^1/2 Pr^1/3, from Re = 5e5 on Nu = 0.037 Re^0.8 Pr^1/3, and at least that of
///   free convection, 1.42 (|T_a - T_s| / length)^1/4;
/// - surface temperature T_s from the heat balance (h_c + 5.5 W/(m2 K) for radiation) (T_a - T_s) = rate / 2 x latent
///   heat, with the rate at a vapour exchange of 1. Water below 0 degrees is treated as liquid.
/// @param speed   of the air along the sheet, m/s; 0 to 100
/// @param length  of the sheet in the direction of the air, m; 1e-3 to 100
/// @throws std::invalid_argument for air, speed or length out of range
DRENCH_API Evaporation evaporation(const Air& air, double speed, double length);

/// Sorption isotherm: the water that fibres bind in humid air, after Guggenheim, Anderson and de Boer (GAB),
/// W = X c y / ((1 - y)(1 - y + c y)) with y = k RH. c is 10 (assumed). X and k are fitted so that the fabric has its
/// regain at 65 % humidity and its bound maximum at 100 %. k is at most 0.999: where the fit needs more (at a regain
/// of 0, say), the bound maximum is met and the moisture content at 65 % is above the regain.
class DRENCH_API Isotherm {
  public:
    /// @throws std::invalid_argument for a fabric that `validate` refuses
    explicit Isotherm(const Fabric& fabric);

    /// Equilibrium moisture content, kg of water per kg of dry cloth, at a relative humidity of 0 to 1 (clamped).
    double moistureContent(double humidity) const;
    /// Inverse of `moistureContent`: equilibrium relative humidity, 0 to 1; 1 at and above the bound maximum.
    double activity(double moistureContent) const;

    /// Monolayer moisture content X, kg/kg.
    double monolayer() const { return monolayer_; }
    /// Constant c of the first layer, dimensionless.
    double firstLayerConstant() const { return firstLayerConstant_; }
    /// Constant k of the further layers, dimensionless; above 0, at most 0.999.
    double multilayerConstant() const { return multilayerConstant_; }

  private:
    double monolayer_;
    double firstLayerConstant_;
    double multilayerConstant_;
};

}  // namespace drench
