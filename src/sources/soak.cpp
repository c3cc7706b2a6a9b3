#include <algorithm>
#include <stdexcept>
#include <utility>

#include "checks/checks.h"
#include "drench/soak.h"

namespace drench {

namespace {

void checkMask(const Mask& mask) {
    mask.at(0, 0);  // throws for a mask without pixels
    for (const float value : mask.values) checkRange("a value of a TimedSoak's mask", value, "", 0, 1);
}

void refuseMissingNodes(const std::vector<std::size_t>& nodes, std::size_t size) {
    for (const std::size_t node : nodes)
        if (node >= size)
            refuse<std::out_of_range>("a TimedSoak was given node ", node, " of a sheet of ", size,
                                      "; nodes count from 0");
}

// Mean value of the mask at the triangle corners of each node; at a seam a node has several material
// coordinates.
std::vector<double> valuesOfNodes(const Mask& mask, const ClothMesh& mesh) {
    Eigen::Vector2d min = Eigen::Vector2d::Constant(1e300), max = -min;
    for (const auto& corners : mesh.coordinates)
        for (const Eigen::Vector2d& corner : corners) {
            min = min.cwiseMin(corner);
            max = max.cwiseMax(corner);
        }
    std::vector<double> sums(mesh.size(), 0.0), counts(mesh.size(), 0.0);
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto node = static_cast<std::size_t>(mesh.triangles[triangle][corner]);
            const Eigen::Vector2d position =
                (mesh.coordinates[triangle][corner] - min).cwiseQuotient(max - min);
            sums[node] += mask.at(position.x(), position.y());
            counts[node] += 1;
        }
    for (std::size_t node = 0; node < sums.size(); ++node)
        if (counts[node] > 0) sums[node] /= counts[node];
    return sums;
}

}  // namespace

TimedSoak::TimedSoak(std::vector<std::size_t> nodes, double mass, double duration)
    : nodes_(std::move(nodes)), amount_(mass), duration_(duration) {
    checkRange("the mass of a TimedSoak", mass, "kg", 0, 1e6);
    checkRange("the duration of a TimedSoak", duration, "s", 0, 1e9);
    if (nodes_.empty()) refuse("a TimedSoak has no nodes; give at least one");
    // Duplicate indices count once.
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
}

TimedSoak TimedSoak::picture(Mask mask, double massPerArea, double duration) {
    checkMask(mask);
    checkRange("the mass per area of a TimedSoak", massPerArea, "kg/m2", 0, 1000);
    checkRange("the duration of a TimedSoak", duration, "s", 0, 1e9);
    TimedSoak soak;
    soak.mask_ = std::move(mask);
    soak.amount_ = massPerArea;
    soak.duration_ = duration;
    return soak;
}

void TimedSoak::supply(const SheetPose& sheet, double dt, Supply& supply) {
    checkStep(dt);
    if (!weighed_) weigh(sheet);
    if (dt == 0 || finished()) return;
    // The steps add up to the whole except for rounding; the last step adds the rest.
    double next = dt < duration_ ? given_ + dt / duration_ : 1;
    if (next > 1 - 1e-12) next = 1;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const double mass = (next - given_) * masses_[i];
        if (mass > 0) supply.addFilm(nodes_[i], mass);
    }
    given_ = next;
}

void TimedSoak::save(StateWriter& writer) const {
    writer.write(given_);
}

void TimedSoak::load(StateReader& reader) {
    const auto given = reader.read<double>();
    if (!(given >= 0 && given <= 1))
        refuse<std::runtime_error>("a TimedSoak cannot have given ", given, " of its water");
    given_ = given;
}

void TimedSoak::weigh(const SheetPose& sheet) {
    if (mask_.width > 0)
        weighPicture(sheet.mesh);
    else
        weighNodes(sheet.mesh);
    weighed_ = true;
}

void TimedSoak::weighNodes(const ClothMesh& mesh) {
    refuseMissingNodes(nodes_, mesh.size());
    double total = 0;
    for (const std::size_t node : nodes_) total += mesh.areas[node];
    if (!(total > 0))
        refuse("none of the nodes of a TimedSoak has cloth; choose nodes whose area is above 0");
    masses_.reserve(nodes_.size());
    for (const std::size_t node : nodes_) masses_.push_back(amount_ * (mesh.areas[node] / total));
}

void TimedSoak::weighPicture(const ClothMesh& mesh) {
    const std::vector<double> values = valuesOfNodes(mask_, mesh);
    for (std::size_t node = 0; node < values.size(); ++node) {
        const double mass = amount_ * mesh.areas[node] * values[node];
        if (!(mass > 0)) continue;
        nodes_.push_back(node);
        masses_.push_back(mass);
    }
}

}  // namespace drench
