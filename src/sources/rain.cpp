#include <algorithm>
#include <cmath>
#include <locale>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "checks/checks.h"
#include "drench/rain.h"

namespace drench {

namespace {

// Cloth stretched to more than this many times its rest area catches no more than at this ratio.
constexpr double maxStretch = 1.5;
// Distance from the node at which a ray for shelter starts, m, so that bodies in contact with the cloth do
// not count.
constexpr double rayStart = 0.01;
// Rain that falls at a slope below 1 in 100 would need an unlimited amount of water on vertical surfaces.
constexpr double minSteepness = 0.01;

void checkSettings(const Rain& rain) {
    checkRange("Rain::intensity", rain.intensity, "mm/h", 0, 1000);
    checkRange("the speed of Rain::velocity", rain.velocity.norm(), "m/s", 0.1, 50);
    checkRange("Rain::shelterHeight", rain.shelterHeight, "m", 0, 1000);
    checkRange("Rain::dropMass", rain.dropMass, "kg", 1e-8, 1e-4);
    checkRange("Rain::maxDrops", rain.maxDrops, "", 1, 1e6);
}

// Downward fraction of the direction of fall. Without gravity the direction of fall itself counts as down.
double steepness(const Rain& rain, const Eigen::Vector3d& fall, const Eigen::Vector3d& up) {
    if (up.isZero()) return 1;
    const double down = -fall.dot(up);
    if (down >= minSteepness) return down;
    refuse("Rain::velocity ", rain.velocity, " m/s does not fall where up is ", sixDigits(up),
           "; give it at least ", minSteepness, " of its speed downwards");
}

// A Poisson random number. Above a million its relative standard deviation is less than a thousandth, so the
// mean is returned.
double randomCount(double mean, std::mt19937& random) {
    if (!(mean > 0)) return 0;
    if (mean > 1e6) return mean;
    return static_cast<double>(std::poisson_distribution<long long>(mean)(random));
}

bool sheltered(const SheetPose& sheet, std::size_t node, const Eigen::Vector3d& fall, double height) {
    if (height <= rayStart) return false;
    const Eigen::Vector3d& position = sheet.positions[node];
    return sheet.shelter.blocked(position - rayStart * fall, position - height * fall);
}

}  // namespace

Rain::Rain(double initialIntensity, std::uint32_t seed) : intensity(initialIntensity), random_(seed) {}

void Rain::supply(const SheetPose& sheet, double dt, Supply& supply) {
    checkSettings(*this);
    checkStep(dt);
    const Eigen::Vector3d fall = velocity.normalized();
    // 1 mm on level ground is 1 kg/m2; slanted rain brings the same to the ground, and so more per area
    // perpendicular to its fall.
    const double fluxAcross = intensity / 3600 / steepness(*this, fall, sheet.up);
    sumAreas(sheet.mesh.areas);
    if (areaUpTo_.empty() || dt == 0) return;

    // More drops are drawn than can land, and each is kept with the probability that its node intercepts it.
    // This gives each node its own Poisson process without a loop over all nodes.
    const double total = areaUpTo_.back();
    const double drawn = randomCount(fluxAcross * total * maxStretch * dt / dropMass, random_);
    const int count = static_cast<int>(std::min(drawn, static_cast<double>(maxDrops)));
    const double massEach = count > 0 ? dropMass * (drawn / count) : 0;
    std::uniform_real_distribution<double> anywhere(0, total), fraction(0, 1);
    for (int drop = 0; drop < count; ++drop) {
        const auto found = std::upper_bound(areaUpTo_.begin(), areaUpTo_.end(), anywhere(random_));
        const double chance = fraction(random_);
        if (found == areaUpTo_.end()) continue;
        const auto node = static_cast<std::size_t>(found - areaUpTo_.begin());
        const double across =
            std::abs(sheet.areaVector(node).dot(fall)) * (1 - sheet.shelter.covered(node, -fall));
        if (!(chance * maxStretch * sheet.mesh.areas[node] < across)) continue;
        if (!sheltered(sheet, node, fall, shelterHeight)) supply.addFilm(node, massEach, velocity);
    }
}

// The standard library gives access to the state of a generator only as text: integers separated by spaces.
void Rain::save(StateWriter& writer) const {
    std::stringstream text;
    text.imbue(std::locale::classic());
    text << random_;
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t number = 0; text >> number;) numbers.push_back(number);
    writer.write(numbers);
}

void Rain::load(StateReader& reader) {
    std::stringstream text;
    text.imbue(std::locale::classic());
    for (const std::uint32_t number : reader.readMany<std::uint32_t>()) text << number << ' ';
    std::mt19937 random;
    if (!(text >> random)) refuse<std::runtime_error>("a Rain's random numbers have no such state");
    random_ = random;
}

// Computed again in every step, which costs less than one ray, because the same rain may fall on several
// sheets.
void Rain::sumAreas(const std::vector<double>& areas) {
    areaUpTo_.resize(areas.size());
    std::partial_sum(areas.begin(), areas.end(), areaUpTo_.begin());
}

}  // namespace drench
