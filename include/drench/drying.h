// How fast wet cloth gives its water to the air, and how much the air leaves it.
#pragma once

#include "drench/air.h"
#include "drench/export.h"
#include "drench/fabric.h"

namespace drench {

/// What air does to a sheet that is wet on both faces.
struct Evaporation {
    double rate;                ///< off both faces together, kg per s and m2 of cloth; at least 0
    double surfaceTemperature;  ///< of the wet cloth, degrees Celsius: near the wet-bulb temperature
    double heatTransfer;        ///< coefficient h_c of convection, W/(m2 K)
};

/// Checks temperature (0 to 60), humidity (0 to 1), vapour exchange (0 to 1), shelter length (0 to 1000) and
/// that the wind is finite and at most 1e4 m/s.
/// @throws std::invalid_argument that names the value and its range
DRENCH_API void validate(const Air& air);

/// Evaporation of a sheet that is wet on both faces (textbook): rate = 2 h_m (rho_sat(T_s) - RH
/// rho_sat(T_a)). The mass transfer coefficient is h_m = h_c / (rho_a c_p) Le^(-2/3), Le = 0.85 (Chilton &
/// Colburn 1934); h_c that of a flat plate, Nu = 0.664 Re^1/2 Pr^1/3, or 0.037 Re^0.8 Pr^1/3 from Re = 5e5
/// on, at least free convection, 1.42 (|T_a - T_s| / length)^1/4. The surface temperature T_s balances (h_c +
/// 5.5 W/(m2 K) of radiation) (T_a - T_s) = rate / 2 x latent heat. The air's vapour exchange then multiplies
/// the rate and leaves the other two as they are. Water colder than 0 degrees counts as liquid.
/// @param speed   of the air along the sheet, m/s, 0 to 100
/// @param length  of the sheet along the air, m, 1e-3 to 100
/// @throws std::invalid_argument for air, speed or length out of range
DRENCH_API Evaporation evaporation(const Air& air, double speed, double length);

/// Water that the fibre binds in humid air: the isotherm of Guggenheim, Anderson and de Boer (GAB), W = X c y
/// / ((1 - y)(1 - y + c y)), y = k RH. c = 10 (assumed); X and k are such that the fabric has its regain at
/// 65 % humidity and its bound maximum at 100 %. Where that takes a k above 0.999, as at a regain of 0, k is
/// 0.999: the bound maximum holds, and the content at 65 % is above the regain.
class DRENCH_API Isotherm {
  public:
    /// @throws std::invalid_argument for a fabric out of range
    explicit Isotherm(const Fabric& fabric);

    /// Water over dry cloth, kg/kg, in balance with air of a relative humidity of 0 to 1 (clamped).
    double content(double humidity) const;
    /// The inverse: relative humidity in balance with a content, 0 to 1; 1 from the bound maximum on.
    double activity(double content) const;

    /// X, kg/kg, the water of the first layer.
    double monolayer() const { return monolayer_; }
    /// c, 1.
    double firstLayerConstant() const { return firstLayerConstant_; }
    /// k, 1, between 0 and 1.
    double multilayerConstant() const { return multilayerConstant_; }

  private:
    double monolayer_;
    double firstLayerConstant_;
    double multilayerConstant_;
};

}  // namespace drench
