// What a cloth is made of. A Fabric never changes while a simulation runs and may be shared by many sheets.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drench/export.h"

namespace drench {

/// Where a number comes from.
enum class Provenance {
    measured,  ///< published measurement; the source says whose
    textbook,  ///< follows from a textbook formula out of other values
    assumed,   ///< our choice, plausible but not measured
    given      ///< set by the application
};

/// "measured", "textbook", "assumed" or "given".
DRENCH_API std::string_view toString(Provenance provenance);

/// A number of a fabric together with where it comes from. Reads as a double; assigning a plain number
/// marks it as given by the application.
struct Quantity {
    double value = 0;                           ///< in the unit of its parameter
    Provenance provenance = Provenance::given;  ///< where it comes from
    std::string source;  ///< author and year, or the reason; may be empty unless measured

    Quantity() = default;
    /// A value given by the application.
    Quantity(double v) : value(v) {}
    /// A value with where it comes from.
    Quantity(double v, Provenance p, std::string s) : value(v), provenance(p), source(std::move(s)) {}
    /// The value alone.
    operator double() const { return value; }
};

/// How the threads of a cloth hold together.
enum class Construction {
    plainWeave,  ///< each thread over one and under one
    twill,       ///< each thread over several and under one, a step aside from row to row
    knit         ///< loops of one thread through those of the row before
};

/// "plain weave", "twill" or "knit".
DRENCH_API std::string_view toString(Construction construction);

/// A woven or knitted cloth in textile units, dry and wet.
///
/// The defaults are those of `fabrics::cottonPlain()`. Change what you know of your own cloth and hand it to
/// `makeSheet` or `WetCloth`; both call `validate`. Warp is the direction of material coordinate u, weft that of v.
/// "Wet" means that the bound water is at its maximum. A star marks parameters that no law of this version uses yet.
struct DRENCH_API Fabric {
    std::string name = "cotton plain";  ///< for messages and files; not empty

    // Construction
    Quantity arealDensity;  ///< mass of dry cloth per area, kg/m2; 0.01 to 3; cotton 0.150
    Quantity thickness;     ///< m; 2e-5 to 0.02; cotton 0.318e-3
    Quantity fibreDensity;  ///< mass of the fibre itself per volume, kg/m3; 700 to 8000; cotton 1520
    Construction construction = Construction::plainWeave;  ///< for the looks alone
    Quantity
        threadSpacing;  ///< from one thread or wale to the next, for the looks alone, m; 5e-5 to 0.02; cotton 3.5e-4

    // Water
    Quantity regain;            ///< water held in air of 65 % humidity, kg/kg; 0 to 0.5; cotton 0.075
    Quantity boundMaximum;      ///< water that softens the fibre, at most, kg/kg; 0.001 to 1; cotton 0.22
    Quantity wettingTime;       ///< time constant from film to pores, s; 1e-3 to 1e5; cotton 2
    Quantity contactAngle;      ///< of water on the fibre, degrees; 0 to 179; cotton 41 *
    Quantity entryPressure;     ///< at which pores start to empty, Pa; 1 to 1e5; cotton 1200
    Quantity permeabilityWarp;  ///< saturated, to water along the warp, m2; 1e-16 to 1e-8; cotton 2e-11
    Quantity permeabilityWeft;  ///< the same along the weft
    Quantity poreSizeIndex;     ///< Brooks-Corey exponent L of the pore sizes, 1; 0.2 to 10; cotton 1

    // Mechanics, dry
    Quantity stretchWarp;  ///< tension per width and strain, N/m; 1 to 1e6; cotton 2000
    Quantity stretchWeft;  ///< the same along the weft
    Quantity shear;        ///< force per width and angle, N/m; 0.1 to 1e6, below both stretches; cotton 60
    Quantity bending;      ///< bending rigidity per width B, N m; 1e-9 to 1; cotton 1.16e-5
    Quantity bendingFriction;  ///< moment per width that friction holds, HB, N; 0 to 1; cotton 6e-4

    // Mechanics, wet over dry
    Quantity wetStretchRatio;          ///< of stretch and shear, 1; 0.01 to 10; cotton 0.6
    Quantity wetBendingRatio;          ///< of the bending rigidity, 1; 0.01 to 10; cotton 0.6
    Quantity wetBendingFrictionRatio;  ///< of the bending friction, 1; 0.01 to 10; cotton 1.7

    // Touch
    Quantity plateFrictionDry;     ///< friction coefficient on a smooth plate, 1; 0 to 5; cotton 0.25
    Quantity plateFrictionDamp;    ///< the same at its damp peak; cotton 0.9
    Quantity plateFrictionSoaked;  ///< the same when a film lubricates; cotton 0.4
    Quantity skinFrictionDry;      ///< friction coefficient on skin, 1; 0 to 5; cotton 0.45
    Quantity skinFrictionDamp;     ///< the same at its damp peak; cotton 1.2
    Quantity skinFrictionSoaked;   ///< the same when a film lubricates; cotton 0.9
    Quantity clingEnergy;  ///< to peel wet cloth off a wettable surface, J/m2; 0 to 0.146; cotton 0.13

    // Air
    Quantity airPermeabilityDry;        ///< air speed through dry cloth at 100 Pa, m/s; 0 to 10; cotton 0.1
    Quantity airPermeabilitySaturated;  ///< the same with full pores, m/s; 0 to the dry value; cotton 0.005

    // Looks
    Quantity albedoRed;       ///< diffuse reflectance, dry, linear, 1; 0.001 to 0.99; cotton 0.20
    Quantity albedoGreen;     ///< the same, green; cotton 0.31
    Quantity albedoBlue;      ///< the same, blue; cotton 0.46
    Quantity scattering;      ///< scattering power S h of the dry cloth, 1; 0.01 to 1000; cotton 6
    Quantity scatteringLoss;  ///< factor q by which scattering falls when wet, 1; 1 to 100; cotton 8

    /// A cotton plain weave; see `fabrics::cottonPlain()`.
    Fabric();

    /// Share of the cloth's volume that is not fibre, 1: 1 - arealDensity / (fibreDensity thickness)
    /// (textbook; Morton & Hearle 2008).
    double porosity() const;

    /// Water that the pores hold when full, kg per m2 of cloth: water density x porosity x thickness.
    double poreCapacity() const;
};

/// One parameter of a fabric: its name as in `Fabric`, unit, range, and where it sits.
struct FabricParameter {
    std::string_view name;     ///< as in `Fabric`
    std::string_view unit;     ///< such as "N/m"; "1" for a number without
    double minimum;            ///< in that unit
    double maximum;            ///< in that unit
    Quantity Fabric::*member;  ///< where it sits
};

/// Every parameter of `Fabric`, in the order of its declaration.
DRENCH_API const std::vector<FabricParameter>& fabricParameters();

/// Checks every parameter for a finite value within its range, and those that depend on each other: porosity from 0.01
/// to 0.999, bound maximum at least 1.6 times the regain, shear below both stretches, saturated air permeability not
/// above the dry one.
/// @throws std::invalid_argument that names the fabric, the parameter, its value and the range.
DRENCH_API void validate(const Fabric& fabric);

/// Ready fabrics. Every value carries its provenance.
namespace fabrics {

DRENCH_API Fabric cottonPlain();     ///< plain-weave scoured cotton shirting, 150 g/m2
DRENCH_API Fabric polyesterPlain();  ///< plain-weave polyester, 120 g/m2: hardly takes water into its fibres
DRENCH_API Fabric polyesterTropical();  ///< polyester suiting, 117 g/m2: its bending and drape are measured
DRENCH_API Fabric wool();               ///< wool suiting, 200 g/m2: wets slowly
DRENCH_API Fabric linen();              ///< linen, 180 g/m2
DRENCH_API Fabric silk();               ///< silk, 70 g/m2
DRENCH_API Fabric nylonTaffeta();       ///< dense nylon taffeta, 70 g/m2
DRENCH_API Fabric denim();              ///< 11 oz cotton denim, 324 g/m2
DRENCH_API Fabric jersey();             ///< cotton single jersey, 160 g/m2: a knit that gives way easily

/// Names that `byName` knows, in the order above: cotton, polyester, tropical, wool, linen, silk, nylon, denim,
/// jersey.
DRENCH_API const std::vector<std::string>& names();

/// The preset of that name. @throws std::invalid_argument that lists the names there are.
DRENCH_API Fabric byName(std::string_view name);

}  // namespace fabrics
}  // namespace drench
