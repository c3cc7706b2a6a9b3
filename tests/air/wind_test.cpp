#include "drench/wind.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "drench/drying.h"

namespace drench::wind_test {
namespace {

using Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;
constexpr double speed = 10, intensity = 0.2, lengthScale = 5;  // m/s, 1, m
constexpr double deviation = intensity * speed;                 // m/s

Gusts gusts(std::uint32_t seed) {
    return {{speed, 0, 0}, intensity, lengthScale, seed};
}

// von Karman's, along the wind, one-sided, m2/s2 per Hz.
double vonKarmanAlong(double frequency) {
    const double reduced = frequency * lengthScale / speed;
    return 4 * deviation * deviation * lengthScale / speed / std::pow(1 + 70.8 * reduced * reduced, 5.0 / 6);
}

// The same across the wind.
double vonKarmanAcross(double frequency) {
    const double reduced = frequency * lengthScale / speed, square = 70.8 * reduced * reduced;
    return 2 * deviation * deviation * lengthScale / speed * (1 + 8.0 / 3 * square) /
           std::pow(1 + square, 11.0 / 6);
}

// Mean over many seeds of the spectra at a fixed place, by Fourier transforms under Hann windows.
struct Spectrum {
    static constexpr int samples = 2048, seeds = 400;
    static constexpr double step = 0.01;  // s
    std::vector<double> along = std::vector<double>(samples / 2, 0.0), across = along;

    Spectrum() {
        std::vector<double> alongRecord(samples), acrossRecord(samples);
        for (std::uint32_t seed = 0; seed < seeds; ++seed) {
            const Gusts wind = gusts(seed);
            for (int i = 0; i < samples; ++i) {
                const Vector3d velocity = wind.velocity({0, 0, 0}, i * step);
                alongRecord[std::size_t(i)] = window(i) * (velocity.x() - speed);
                acrossRecord[std::size_t(i)] = window(i) * velocity.y();
            }
            add(alongRecord, along);
            add(acrossRecord, across);
        }
    }
    // Of a mean square of 1.
    static double window(int i) { return std::sqrt(2.0 / 3) * (1 - std::cos(2 * pi * i / samples)); }
    static void add(const std::vector<double>& record, std::vector<double>& sum) {
        Eigen::FFT<double> transform;
        std::vector<std::complex<double>> lines;
        transform.fwd(lines, record);
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += 2 * std::norm(lines[i]) * step / samples / seeds;
    }
    // Over what the formula has there, in the mean over a band of frequencies.
    static double ratio(const std::vector<double>& spectrum, double (*formula)(double), double from,
                        double to) {
        double found = 0, wanted = 0;
        for (std::size_t i = 0; i < spectrum.size(); ++i) {
            const double frequency = double(i) / (samples * step);
            if (frequency < from || frequency >= to) continue;
            found += spectrum[i];
            wanted += formula(frequency);
        }
        return found / wanted;
    }
};

TEST(Gusts, HaveTheSpectrumOfVonKarman) {
    const Spectrum spectrum;
    // Octaves of 400 seeds, of which each has few waves in an octave: that leaves some 4 % to chance; and
    // the waves that are left out give the others 3 % more.
    for (double from = 0.15; from < 9; from *= 2) {
        EXPECT_NEAR(Spectrum::ratio(spectrum.along, vonKarmanAlong, from, 2 * from), 1, 0.1) << from;
        EXPECT_NEAR(Spectrum::ratio(spectrum.across, vonKarmanAcross, from, 2 * from), 1, 0.1) << from;
    }
}

TEST(Gusts, HaveTheVarianceAskedForInEachComponent) {
    // Over places so far apart that they know nothing of each other.
    Vector3d mean = Vector3d::Zero(), squares = Vector3d::Zero();
    double worst = 0;
    constexpr int seeds = 100, positions = 400;
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        const Gusts wind = gusts(seed);
        Vector3d ofOne = Vector3d::Zero();
        for (int i = 0; i < positions; ++i) {
            const Vector3d turbulence =
                wind.velocity({37.7 * i, 91.3 * (i % 17), 53.1 * (i % 23)}, 0) - Vector3d(speed, 0, 0);
            mean += turbulence / (seeds * positions);
            ofOne += turbulence.cwiseAbs2() / positions;
        }
        squares += ofOne / seeds;
        worst = std::max(worst, (ofOne / (deviation * deviation) - Vector3d::Ones()).cwiseAbs().maxCoeff());
    }
    EXPECT_LT(mean.norm(), 0.02 * deviation);
    for (int component = 0; component < 3; ++component)
        EXPECT_NEAR(squares[component], deviation * deviation, 0.02 * deviation * deviation);
    EXPECT_LT(worst, 0.3) << "no seed is very uneven";
}

TEST(Gusts, NeitherGatherNorThin) {
    const Gusts wind = gusts(4);
    constexpr double apart = 1e-4 * lengthScale;
    for (int i = 0; i < 50; ++i) {
        const Vector3d position(0.31 * i, 0.17 * i, -0.23 * i);
        double divergence = 0, steepness = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const Vector3d half = 0.5 * apart * Vector3d::Unit(axis);
            const Vector3d slope =
                (wind.velocity(position + half, 1.5) - wind.velocity(position - half, 1.5)) / apart;
            divergence += slope[axis];
            steepness += slope.norm();
        }
        EXPECT_NEAR(divergence, 0, 1e-3 * steepness);
    }
}

TEST(Gusts, AreCarriedByTheMeanWind) {
    const Gusts wind({4, -3, 1}, 0.3, 2, 9);
    for (const double time : {0.1, 7.0, 5000.0})
        EXPECT_LT(
            (wind.velocity(Vector3d(1, 2, 3) + time * Vector3d(4, -3, 1), time) - wind.velocity({1, 2, 3}, 0))
                .norm(),
            1e-6)
            << time;
}

TEST(Gusts, AreSmooth) {
    // No jump where the phase of a wave begins a new turn: steps of 0.1 ms and 0.01 ms differ tenfold.
    const Gusts wind = gusts(2);
    const auto largestStep = [&wind](double step) {
        double largest = 0;
        for (int i = 0; i < 20000; ++i)
            largest = std::max(
                largest,
                (wind.velocity({0, 0, 0}, (i + 1) * step) - wind.velocity({0, 0, 0}, i * step)).norm());
        return largest;
    };
    EXPECT_LT(largestStep(1e-4), 0.05 * deviation);
    EXPECT_LT(largestStep(1e-5), 0.005 * deviation);
}

TEST(Gusts, AreTheSameForTheSameSeedOnly) {
    const Gusts one = gusts(1), again = gusts(1), other = gusts(2);
    const Vector3d position(1, 2, 3);
    EXPECT_EQ(one.velocity(position, 4), again.velocity(position, 4));
    EXPECT_GT((one.velocity(position, 4) - other.velocity(position, 4)).norm(), 0.01 * deviation);
    EXPECT_EQ(Gusts({3, 0, 0}, 0, 5).velocity(position, 4), Vector3d(3, 0, 0));
    EXPECT_EQ(Gusts({0, 0, 0}, 0.2, 5).velocity(position, 4), Vector3d(0, 0, 0));
}

std::string refusal(const std::function<void()>& action) {
    try {
        action();
    } catch (const std::invalid_argument& problem) {
        return problem.what();
    }
    return "";
}

TEST(Gusts, RefuseWhatMakesNoWind) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Vector3d& mean : {Vector3d(101, 0, 0), Vector3d(0, nan, 0)})
        EXPECT_NE(refusal([&] { Gusts(mean, 0.2, 5); }).find("mean speed of Gusts"), std::string::npos);
    for (const double bad : {-0.01, 1.01, nan})
        EXPECT_NE(refusal([&] { Gusts({1, 0, 0}, bad, 5); }).find("intensity of Gusts"), std::string::npos);
    for (const double bad : {0.0, 1001.0, nan})
        EXPECT_NE(refusal([&] {
                      Gusts({1, 0, 0}, 0.2, bad);
                  }).find("length scale of Gusts"),
                  std::string::npos);
}

TEST(Air, RefusesAShelterLengthOutOfRange) {
    Air air;
    EXPECT_EQ(refusal([&] { validate(air); }), "");
    for (const double bad : {-1.0, 1001.0, std::numeric_limits<double>::quiet_NaN()}) {
        air.shelterLength = bad;
        EXPECT_NE(refusal([&] { validate(air); }).find("shelterLength"), std::string::npos);
    }
}

TEST(Air, RefusesAWindThatIsNotOfThisEarth) {
    Air air;
    air.wind = {6000, 0, -8000};
    EXPECT_EQ(refusal([&] { validate(air); }), "");
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Vector3d& bad : {Vector3d(0, 1.01e4, 0), Vector3d(1e19, 0, 0), Vector3d(0, 0, 1e300),
                                Vector3d(0, nan, 0), Vector3d(HUGE_VAL, 0, 0)}) {
        air.wind = bad;
        EXPECT_NE(refusal([&] { validate(air); }).find("air wind is ("), std::string::npos) << bad;
    }
}

}  // namespace
}  // namespace drench::wind_test
