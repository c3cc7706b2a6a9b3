#include <algorithm>
#include <cmath>
#include <numeric>

#include "checks/checks.h"
#include "cloth/constants.h"
#include "drench/spray.h"

namespace drench {

namespace {

// Smallest distance that is used for a node, m: a node at the nozzle itself would fill the whole solid angle.
constexpr double nearest = 1e-3;
// Distance from the node at which a ray for shelter ends, m, so that bodies in contact with the cloth do not
// count.
constexpr double rayEnd = 0.01;

void checkSettings(const Spray& spray) {
    checkPosition("Spray::origin", spray.origin);
    checkPosition("Spray::direction", spray.direction);
    if (!(spray.direction.norm() > 0))
        refuse("Spray::direction is (0, 0, 0); give the direction in which the nozzle points");
    checkRange("Spray::halfAngle", spray.halfAngle, "rad", 0.01, 1.5);
    checkRange("Spray::rate", spray.rate, "kg/s", 0, 1000);
    checkRange("Spray::speed", spray.speed, "m/s", 0, 100);
    checkRange("Spray::raysPerStep", spray.raysPerStep, "", 1, 1e6);
}

// Unit vector from the nozzle to a position; at the nozzle itself, along the axis of the cone.
Eigen::Vector3d directionTo(const Spray& spray, const Eigen::Vector3d& position) {
    const Eigen::Vector3d offset = position - spray.origin;
    const double distance = offset.norm();
    if (distance > 0) return offset / distance;
    return spray.direction.normalized();
}

// Solid angle of a node seen from the nozzle, sr; 0 outside the cone.
double solidAngle(const Spray& spray, const SheetPose& sheet, std::size_t node) {
    if (!(sheet.mesh.areas[node] > 0)) return 0;
    const Eigen::Vector3d& position = sheet.positions[node];
    const Eigen::Vector3d direction = directionTo(spray, position);
    if (!(direction.dot(spray.direction.normalized()) >= std::cos(spray.halfAngle))) return 0;
    const double distance = std::max((position - spray.origin).norm(), nearest);
    const double open = 1 - sheet.shelter.covered(node, -direction);
    return open * std::abs(sheet.areaVector(node).dot(direction)) / (distance * distance);
}

bool isBlocked(const Spray& spray, const SheetPose& sheet, std::size_t node) {
    const Eigen::Vector3d& position = sheet.positions[node];
    if ((position - spray.origin).norm() <= rayEnd) return false;
    return sheet.shelter.blocked(spray.origin, position - rayEnd * directionTo(spray, position));
}

}  // namespace

Spray::Spray(const Eigen::Vector3d& initialOrigin, const Eigen::Vector3d& initialDirection,
             double initialRate)
    : origin(initialOrigin), direction(initialDirection), rate(initialRate) {}

void Spray::supply(const SheetPose& sheet, double dt, Supply& supply) {
    checkSettings(*this);
    checkStep(dt);
    if (dt == 0) return;
    distribute(sheet);
    askForShelter(sheet);
    for (std::size_t node = 0; node < fractions_.size(); ++node) {
        const double mass = rate * dt * fractions_[node];
        if (!(mass > 0) || sheltered_[node]) continue;
        supply.addFilm(node, mass, speed * directionTo(*this, sheet.positions[node]));
    }
}

void Spray::save(StateWriter& writer) const {
    writer.write(static_cast<std::uint64_t>(nextRay_));
    writer.write(sheltered_);
}

void Spray::load(StateReader& reader) {
    const auto next = reader.read<std::uint64_t>();
    std::vector<char> sheltered = reader.readMany<char>();
    nextRay_ = static_cast<std::size_t>(next);  // continues at the first node after the last one
    sheltered_ = std::move(sheltered);          // tested again if the number of nodes has changed
}

void Spray::distribute(const SheetPose& sheet) {
    const double cone = 2 * pi * (1 - std::cos(halfAngle));
    fractions_.resize(sheet.mesh.size());
    for (std::size_t node = 0; node < fractions_.size(); ++node)
        fractions_[node] = solidAngle(*this, sheet, node) / cone;
    // Folds behind folds, and nodes at the nozzle, may add up to more than the cone.
    const double sum = std::accumulate(fractions_.begin(), fractions_.end(), 0.0);
    if (sum > 1)
        for (double& fraction : fractions_) fraction /= sum;
}

void Spray::askForShelter(const SheetPose& sheet) {
    const std::size_t count = fractions_.size();
    if (sheltered_.size() != count) sheltered_.assign(count, 0);
    if (nextRay_ >= count) nextRay_ = 0;
    int asked = 0;
    for (std::size_t looked = 0; looked < count && asked < raysPerStep; ++looked) {
        const std::size_t node = nextRay_;
        nextRay_ = (nextRay_ + 1) % count;
        if (!(fractions_[node] > 0)) continue;
        sheltered_[node] = isBlocked(*this, sheet, node);
        ++asked;
    }
}

}  // namespace drench
