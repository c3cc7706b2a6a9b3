#include "drench/wind.h"

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "checks/checks.h"
#include "cloth/constants.h"

namespace drench {

namespace {

// Length in von Karman's energy spectrum over the integral length scale (textbook).
constexpr double spectralLength = 1.339;
// Wave numbers times that length, from below which and above which there is hardly any energy.
constexpr double smallestWaveNumber = 0.1, largestWaveNumber = 400;

// Shape of the energy spectrum E(k), over kappa = k x spectral length (von Karman 1948).
double energyAt(double kappa) {
    return std::pow(kappa, 4) / std::pow(1 + kappa * kappa, 17.0 / 6);
}

double fraction(double value) {
    return value - std::floor(value);
}

// Directions that are spread evenly for any number of them (two-dimensional sequence of Roberts 2018), so
// that the few waves with much energy do not favour one side.
Eigen::Vector3d spreadDirection(std::size_t index, double firstHeight, double firstTurn) {
    const double height = 2 * fraction(firstHeight + 0.7548776662466927 * double(index)) - 1;
    const double angle = 2 * pi * fraction(firstTurn + 0.5698402909980532 * double(index));
    const double radius = std::sqrt(1 - height * height);
    return {radius * std::cos(angle), radius * std::sin(angle), height};
}

struct SineCosine {
    double sine, cosine;
};

// Cosine and sine of an angle in turns, accurate to 1e-9. Written in plain arithmetic, so that the loop over
// waves is vectorised.
inline SineCosine ofTurns(double turns) {
    constexpr double toWhole = 6755399441055744.0;  // 1.5 x 2^52: adding it rounds to whole turns
    const double half = pi * (turns - ((turns + toWhole) - toWhole));
    const double q = half * half;  // the Taylor series of the half angle, at most pi / 2
    const double sine =
        half *
        (1 + q * (-1.0 / 6 +
                  q * (1.0 / 120 + q * (-1.0 / 5040 + q * (1.0 / 362880 + q * (-1.0 / 39916800 +
                                                                               q * (1.0 / 6227020800)))))));
    const double cosine =
        1 + q * (-1.0 / 2 +
                 q * (1.0 / 24 + q * (-1.0 / 720 + q * (1.0 / 40320 + q * (-1.0 / 3628800 +
                                                                           q * (1.0 / 479001600 -
                                                                                q * (1.0 / 87178291200)))))));
    return {2 * sine * cosine, 1 - 2 * sine * sine};
}

}  // namespace

Gusts::Gusts(const Eigen::Vector3d& mean, double intensity, double lengthScale, std::uint32_t seed)
    : mean_(mean), lengthScale_(lengthScale) {
    checkRange("the mean speed of Gusts", mean.norm(), "m/s", 0, 100);
    checkRange("the intensity of Gusts", intensity, "", 0, 1);
    checkRange("the length scale of Gusts", lengthScale, "m", 0.01, 1000);

    std::mt19937 random(seed);
    const auto uniform = [&random] { return double(random()) / 4294967296.0; };
    const double firstHeight = uniform(), firstTurn = uniform();
    double energy = 0;
    for (std::size_t wave = 0; wave < waveCount; ++wave) {
        const double step = (double(wave) + uniform()) / double(waveCount);
        const double kappa = smallestWaveNumber * std::pow(largestWaveNumber / smallestWaveNumber, step);
        const Eigen::Vector3d direction = spreadDirection(wave, firstHeight, firstTurn);
        phases_[wave] = uniform();
        // Bands of equal width in log k contain an energy proportional to k E(k).
        const double amplitude = std::sqrt(kappa * energyAt(kappa));
        energy += amplitude * amplitude;
        const Eigen::Vector3d across = amplitude * direction.unitOrthogonal();
        const Eigen::Vector3d onwards = (uniform() < 0.5 ? 1.0 : -1.0) * direction.cross(across);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto component = static_cast<Eigen::Index>(axis);
            turns_[axis][wave] = kappa / (spectralLength * lengthScale) * direction[component] / (2 * pi);
            withCosine_[axis][wave] = across[component];
            withSine_[axis][wave] = onwards[component];
        }
    }
    // The squared speed of a circularly polarised wave equals that of its amplitude at all times.
    const double scale = intensity * mean.norm() * std::sqrt(3 / energy);
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t wave = 0; wave < waveCount; ++wave) {
            withCosine_[axis][wave] *= scale;
            withSine_[axis][wave] *= scale;
        }
}

Eigen::Vector3d Gusts::velocity(const Eigen::Vector3d& position, double time) const {
    const Eigen::Vector3d carried = position - time * mean_;
    const double right = carried.x(), up = carried.y(), near = carried.z();
    double x = 0, y = 0, z = 0;
#pragma omp simd reduction(+ : x, y, z)
    for (std::size_t wave = 0; wave < waveCount; ++wave) {
        const SineCosine at =
            ofTurns(phases_[wave] + turns_[0][wave] * right + turns_[1][wave] * up + turns_[2][wave] * near);
        x += withCosine_[0][wave] * at.cosine + withSine_[0][wave] * at.sine;
        y += withCosine_[1][wave] * at.cosine + withSine_[1][wave] * at.sine;
        z += withCosine_[2][wave] * at.cosine + withSine_[2][wave] * at.sine;
    }
    return mean_ + Eigen::Vector3d(x, y, z);
}

double Gusts::length() const {
    return 0.05 * lengthScale_;
}

}  // namespace drench
