// Physical constants of water and air.
#pragma once

namespace drench {

inline constexpr double waterDensity = 1000.0;         ///< kg/m3 (textbook, 20 C rounded)
inline constexpr double waterViscosity = 1.0e-3;       ///< Pa s (textbook, 20 C)
inline constexpr double waterSurfaceTension = 0.0728;  ///< N/m (textbook, 20 C)
inline constexpr double waterRefractiveIndex = 1.33;   ///< dimensionless (textbook)
inline constexpr double airDensity = 1.2;              ///< kg/m3 (textbook, 20 C at sea level)
inline constexpr double standardGravity = 9.81;  ///< m/s2 (textbook); used where no other gravity is given

/// Thickness of the film that a face retains; only thicker film runs, m (assumed).
inline constexpr double retainedFilmThickness = 18e-6;
/// Largest film thickness on a face; what exceeds it drips, m (assumed).
inline constexpr double thickestFilm = 0.3e-3;
/// Mass of a drop that falls from cloth, kg (assumed; Tate's law, 0.62 x 2 pi r gamma / g, gives 30 to 85 mg for r = 1
/// to 3 mm).
inline constexpr double dropMass = 50e-6;

}  // namespace drench
