// Wind that changes from place to place and from moment to moment.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "drench/export.h"

namespace drench {

/// Moving air as a function of place and time. Derive from it for a wind of your own, such as that of a fan,
/// and hand it to `Air::field`.
class DRENCH_API WindField {
  public:
    virtual ~WindField() = default;

    /// Velocity of the air, m/s; finite, at most 1e4. Smooth in place and time, or cloth jerks. What it throws
    /// comes out of the step. Called at most 216 times a step for each sheet.
    /// @param place  in the world, m
    /// @param time   of the body since its WetCloth was made, s
    virtual Eigen::Vector3d velocity(const Eigen::Vector3d& place, double time) const = 0;

    /// How far apart the velocity may be read and interpolated between, m; above 0, and infinite for a wind
    /// that is the same everywhere.
    virtual double length() const = 0;
};

/// A mean wind with natural turbulence: 64 divergence-free waves in random directions (Kraichnan 1970) with the
/// energy spectrum of von Karman (1948), which the mean wind carries along unchanged (Taylor 1938). In each
/// wave the velocity turns in a circle, so that its energy is the same everywhere.
///
/// In the mean over seeds the spectrum of the velocity along the wind is then, one-sided, 4 s^2 (L / U) / (1 +
/// 70.8 (f L / U)^2)^(5/6), f the frequency, U the mean speed, L the length scale, s = intensity x U. The waves
/// are 84 L to 0.021 L long, spread evenly over the logarithm of their wave numbers; that gives the formula up
/// to f = 5 U / L within 3 %, a ninth too little at 10 U / L, and nothing from 48 U / L on. The variance is s^2
/// in each component in the mean over seeds, and of one seed over all places within 30 % of it; at one place
/// over time it is less, as waves whose fronts lie along the wind do not change there.
///
/// A step reads it at up to 216 points: eddies shorter than two of their distances are not averaged over the
/// cloth, so that of a length scale below the size of the sheet it feels somewhat too much.
///
/// Does not change once made: to change the wind, make another; the eddies then jump.
class DRENCH_API Gusts final : public WindField {
  public:
    /// @param mean         velocity of the wind, m/s, up to 100; included in `velocity`, so leave `Air::wind` at 0
    /// @param intensity    standard deviation of each component over the mean speed, 1; 0 to 1. In open country
    ///                     0.15 to 0.2, between houses 0.3 and more (textbook)
    /// @param lengthScale  integral length scale L of the velocity along the wind, m; 0.01 to 1000. Near the
    ///                     ground about the height above it (textbook)
    /// @param seed         the same seed gives the same wind on one platform
    /// @throws std::invalid_argument that names the value and its range
    Gusts(const Eigen::Vector3d& mean, double intensity, double lengthScale, std::uint32_t seed = 1);

    Eigen::Vector3d velocity(const Eigen::Vector3d& place, double time) const override;
    /// A twentieth of the length scale: the waves that are longer than two of these have 95 % of the energy.
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
