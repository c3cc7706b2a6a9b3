// Wind that varies in space and time.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "drench/config.h"

namespace drench {

/// Air velocity as a function of position and time. Derive from it for a wind of your own, such as that of a fan, and
/// assign it to `Air::field`.
class DRENCH_API WindField {
  public:
    virtual ~WindField() = default;

    /// Velocity of the air, m/s; finite, at most 1e4. Should be smooth in space and time, or cloth jerks. Called at
    /// most 216 times per step and sheet.
    ///
    /// If it throws a std::exception or returns an invalid velocity, the last valid air is used, and this is reported
    /// as `Trouble::air`; with `OnTrouble::throwError` the exception leaves the step.
    /// @param position  in the world, m
    /// @param time      of the body since its WetCloth was made, s
    virtual Eigen::Vector3d velocity(const Eigen::Vector3d& position, double time) const = 0;

    /// Largest distance over which the velocity may be interpolated, m; above 0; infinite for a uniform wind.
    virtual double length() const = 0;
};

/// A mean wind with turbulence: 64 divergence-free waves in random directions (Kraichnan 1970) with the energy spectrum
/// of von Karman (1948), carried along unchanged by the mean wind (Taylor 1938). In each wave the velocity is
/// circularly polarised, so that its energy is the same everywhere.
///
/// The one-sided spectrum of the velocity along the wind, averaged over seeds, is 4 s^2 (L / U) / (1 + 70.8 (f L /
/// U)^2)^(5/6), with f the frequency, U the mean speed, L the length scale and s = intensity x U. The wave lengths are
/// 84 L to 0.021 L, evenly spaced in the logarithm. This reproduces the formula within 3 % up to f = 5 U / L, gives a
/// ninth too little at 10 U / L, and nothing from 48 U / L on. The variance of each component is s^2 averaged over
/// seeds; for one seed, averaged over space, it is within 30 % of that. At a fixed point it is less, because waves
/// whose fronts are parallel to the wind do not change there.
///
/// A step evaluates it at up to 216 points. Eddies shorter than twice the distance of these points are not averaged
/// over the cloth; so with a length scale below the size of the sheet the wind force varies somewhat too much.
///
/// Immutable: to change the wind, make another; the eddies are then different ones.
class DRENCH_API Gusts final : public WindField {
  public:
    /// @param mean         mean velocity, m/s; at most 100. `velocity` includes it, so leave `Air::wind` at 0
    /// @param intensity    standard deviation of each component over the mean speed, dimensionless; 0 to 1. In open
    ///                     country 0.15 to 0.2, between houses 0.3 and more (textbook)
    /// @param lengthScale  integral length scale L of the velocity along the wind, m; 0.01 to 1000. Near the ground
    ///                     about the height above it (textbook)
    /// @param seed         the same seed gives the same wind on one platform
    /// @throws std::invalid_argument that names the value and its range
    Gusts(const Eigen::Vector3d& mean, double intensity, double lengthScale, std::uint32_t seed = 1);

    Eigen::Vector3d velocity(const Eigen::Vector3d& position, double time) const override;
    /// A twentieth of the length scale: waves longer than twice that have 95 % of the energy.
    double length() const override;

  private:
    static constexpr std::size_t waveCount = 64;
    using OfWaves = std::array<double, waveCount>;

    Eigen::Vector3d mean_;
    double lengthScale_;
    OfWaves phases_;                     // turns
    std::array<OfWaves, 3> turns_;       // per metre along each axis
    std::array<OfWaves, 3> withCosine_;  // components of the velocity, m/s
    std::array<OfWaves, 3> withSine_;
};

}  // namespace drench
