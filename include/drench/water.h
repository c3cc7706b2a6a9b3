// The liquid itself: constants of water and air that no application changes.
#pragma once

namespace drench {

inline constexpr double waterDensity = 1000.0;        ///< kg/m3 (textbook, 20 C rounded)
inline constexpr double waterViscosity = 1.0e-3;      ///< Pa s (textbook, 20 C)
inline constexpr double waterRefractiveIndex = 1.33;  ///< 1 (textbook)
inline constexpr double airDensity = 1.2;             ///< kg/m3 (textbook, 20 C at sea level)

}  // namespace drench
