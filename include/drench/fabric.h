// Properties of a fabric. A Fabric does not change while a simulation runs; many sheets may share one.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drench/config.h"

namespace drench {

/// Where a value comes from.
enum class Provenance {
    measured,  ///< published measurement; `Quantity::source` names it
    textbook,  ///< computed from other values by a textbook formula
    assumed,   ///< chosen for Drench; plausible, not measured
    given      ///< set by the application
};

/// "measured", "textbook", "assumed" or "given".
DRENCH_API std::string_view toString(Provenance provenance);

/// One value of a fabric with its provenance. Converts to double; a plain number that is assigned to it is marked
/// as given by the application.
struct Quantity {
    double value = 0;                           ///< in the unit of its parameter
    Provenance provenance = Provenance::given;  ///< where the value comes from
    std::string source;  ///< author and year, or the reason; must not be empty if measured

    Quantity() = default;
    /// A value given by the application.
    Quantity(double v) : value(v) {}
    /// A value with its provenance and source.
    Quantity(double v, Provenance p, std::string s) : value(v), provenance(p), source(std::move(s)) {}
    /// The value alone.
    operator double() const { return value; }
};

/// How a cloth is made from threads.
enum class Construction {
    plainWeave,  ///< each thread passes over one and under one
    twill,       ///< each thread passes over several and under one, shifted by one from row to row
    knit         ///< loops, each pulled through one of the row before
};

/// "plain weave", "twill" or "knit".
DRENCH_API std::string_view toString(Construction construction);

/// A woven or knitted cloth, dry and wet.
///
/// The defaults are those of `fabrics::cottonPlain()`, given below as "cotton". Change what you know about your own
/// cloth and pass it to `makeSheet` or `WetCloth`; both call `validate`. The warp is the direction of material
/// coordinate u, the weft that of v. Bound water softens the fibre; "wet" means that it is at its maximum. A star (*)
/// marks parameters that this version does not use.
struct DRENCH_API Fabric {
    std::string name = "cotton plain";  ///< used in messages and files; not empty

    // Construction
    Quantity arealDensity;  ///< mass of dry cloth per area, kg/m2; 0.01 to 3; cotton 0.150
    Quantity thickness;     ///< m; 2e-5 to 0.02; cotton 0.318e-3
    Quantity fibreDensity;  ///< density of the fibre without pores, kg/m3; 700 to 8000; cotton 1520
    Construction construction = Construction::plainWeave;  ///< affects rendering only
    /// Distance between neighbouring threads or wales, m; 5e-5 to 0.02; cotton 3.5e-4. Affects rendering only.
    Quantity threadSpacing;

    // Water
    Quantity regain;            ///< moisture content in air of 65 % humidity, kg/kg; 0 to 0.5; cotton 0.075
    Quantity boundMaximum;      ///< largest content of bound water, kg/kg; 0.001 to 1; cotton 0.22
    Quantity wettingTime;       ///< time constant of absorption from film to pores, s; 1e-3 to 1e5; cotton 2
    Quantity contactAngle;      ///< of water on the fibre, degrees; 0 to 179; cotton 41 (*)
    Quantity entryPressure;     ///< suction at which pores start to empty, Pa; 1 to 1e5; cotton 1200
    Quantity permeabilityWarp;  ///< to water along the warp, saturated, m2; 1e-16 to 1e-8; cotton 2e-11
    Quantity permeabilityWeft;  ///< to water along the weft; same unit, range and default
    Quantity poreSizeIndex;     ///< Brooks-Corey pore size index L, dimensionless; 0.2 to 10; cotton 1

    // Mechanics, dry
    Quantity stretchWarp;  ///< tension per width over strain, N/m; 1 to 1e6; cotton 2000
    Quantity stretchWeft;  ///< the same along the weft
    Quantity shear;    ///< force per width over shear angle, N/m; 0.1 to 1e6, below both stretches; cotton 60
    Quantity bending;  ///< bending rigidity per width B, N m; 1e-9 to 1; cotton 1.16e-5
    Quantity bendingFriction;  ///< friction moment per width HB, N; 0 to 1; cotton 6e-4

    // Mechanics, ratios of wet to dry
    Quantity wetStretchRatio;          ///< of stretch and shear, dimensionless; 0.01 to 10; cotton 0.6
    Quantity wetBendingRatio;          ///< of the bending rigidity, dimensionless; 0.01 to 10; cotton 0.6
    Quantity wetBendingFrictionRatio;  ///< of the bending friction, dimensionless; 0.01 to 10; cotton 1.7

    // Friction and adhesion
    Quantity plateFrictionDry;     ///< friction coefficient on a smooth plate; 0 to 5; cotton 0.25
    Quantity plateFrictionDamp;    ///< the same for damp cloth, the maximum; cotton 0.9
    Quantity plateFrictionSoaked;  ///< the same when lubricated by a film; cotton 0.4
    Quantity skinFrictionDry;      ///< friction coefficient on skin; 0 to 5; cotton 0.45
    Quantity skinFrictionDamp;     ///< the same for damp cloth, the maximum; cotton 1.2
    Quantity skinFrictionSoaked;   ///< the same when lubricated by a film; cotton 0.9
    Quantity clingEnergy;  ///< energy to peel wet cloth off a wettable surface, J/m2; 0 to 0.146; cotton 0.13

    // Air
    Quantity airPermeabilityDry;        ///< air speed through dry cloth at 100 Pa, m/s; 0 to 10; cotton 0.1
    Quantity airPermeabilitySaturated;  ///< the same with full pores, m/s; 0 to the dry value; cotton 0.005

    // Rendering
    Quantity albedoRed;       ///< diffuse reflectance of dry cloth, linear; 0.001 to 0.99; cotton 0.20
    Quantity albedoGreen;     ///< the same, green; cotton 0.31
    Quantity albedoBlue;      ///< the same, blue; cotton 0.46
    Quantity scattering;      ///< scattering power S h of dry cloth, dimensionless; 0.01 to 1000; cotton 6
    Quantity scatteringLoss;  ///< scattering power of dry over wet cloth, dimensionless; 1 to 100; cotton 8

    // Layers of cloth, and cloth under pressure
    Quantity permeabilityThrough;  ///< to water through the cloth, saturated, m2; 1e-17 to 1e-8; cotton 2e-12
    /// Thickness under 5 kPa over `thickness`, dimensionless: Tm over T0 of a KES compression test; 0.02 to 1, more than
    /// the fibres alone take up, 1 - porosity; cotton 0.75. See `thicknessUnder`.
    Quantity pressedThicknessRatio;

    /// A cotton plain weave; see `fabrics::cottonPlain()`.
    Fabric();

    /// Fraction of the cloth's volume that is not fibre, dimensionless: 1 - arealDensity / (fibreDensity thickness)
    /// (textbook; Morton & Hearle 2008).
    double porosity() const;

    /// Water in full pores, kg per m2 of cloth: water density x porosity x thickness.
    double poreCapacity() const;

    /// Thickness under a pressure, m: t_f + (t - t_f) (1 + c p / 5 kPa)^(-1/3), with t_f the thickness that the fibres
    /// alone take up and c such that it is pressedThicknessRatio x thickness at 5 kPa (van Wyk 1946 for masses of fibres,
    /// with an incompressible part as de Jong et al. 1986).
    /// @param pressure  Pa; at least 0
    double thicknessUnder(double pressure) const;

    /// Water that pores hold at most under a pressure, kg per m2 of cloth: the room that is left at that thickness, of
    /// which capillarity keeps (entryPressure / pressure)^poreSizeIndex (Brooks & Corey 1964), and at least the bound
    /// water, which no such pressure removes.
    /// @param pressure  Pa; at least 0
    double poreCapacityUnder(double pressure) const;
};

/// Description of one parameter of `Fabric`.
struct FabricParameter {
    std::string_view name;     ///< as in `Fabric`
    std::string_view unit;     ///< such as "N/m"; "1" if dimensionless
    double minimum;            ///< smallest allowed value, in that unit
    double maximum;            ///< largest allowed value, in that unit
    Quantity Fabric::*member;  ///< pointer to the member
};

/// All parameters of `Fabric`, in the order of declaration.
DRENCH_API const std::vector<FabricParameter>& fabricParameters();

/// Checks that every parameter is finite and in its range, and that they fit each other: porosity from 0.01 to 0.999,
/// bound maximum at least 1.6 times the regain, shear below both stretch values, saturated air permeability not above
/// the dry one.
/// @throws std::invalid_argument that names the fabric, the parameter, its value and the range.
DRENCH_API void validate(const Fabric& fabric);

/// Ready-made fabrics. Every value has its provenance.
namespace fabrics {

DRENCH_API Fabric cottonPlain();        ///< plain-weave scoured cotton shirting, 150 g/m2
DRENCH_API Fabric polyesterPlain();     ///< plain-weave polyester, 120 g/m2; its fibres bind hardly any water
DRENCH_API Fabric polyesterTropical();  ///< polyester suiting, 117 g/m2; bending and drape are measured
DRENCH_API Fabric wool();               ///< wool suiting, 200 g/m2; wets slowly
DRENCH_API Fabric linen();              ///< linen, 180 g/m2
DRENCH_API Fabric silk();               ///< silk, 70 g/m2
DRENCH_API Fabric nylonTaffeta();       ///< dense nylon taffeta, 70 g/m2
DRENCH_API Fabric denim();              ///< 11 oz cotton denim, 324 g/m2
DRENCH_API Fabric jersey();             ///< cotton single jersey, 160 g/m2; a knit that stretches easily

/// Names for `byName`, in the order above: cotton, polyester, tropical, wool, linen, silk, nylon, denim, jersey.
DRENCH_API const std::vector<std::string>& names();

/// The fabric of that name. @throws std::invalid_argument that lists the names, for an unknown one.
DRENCH_API Fabric byName(std::string_view name);

}  // namespace fabrics
}  // namespace drench
