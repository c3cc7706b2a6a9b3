#include "bullet/fluid/wind_at_nodes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bullet/fluid/rigid_shelter.h"
#include "bullet/simd/node_arrays.h"
#include "bullet/world/vectors.h"
#include "checks/checks.h"
#include "cloth/compressed_rows.h"
#include "drench/wind.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

constexpr double fastest = 1e4;  // m/s
constexpr std::size_t raysPerStep = 32;
// Number of patches of a sheet; small sheets have fewer.
constexpr std::size_t maxPatches = 256, minNodes = 16;
// Time constant with which the shelter follows the results of the rays, s (assumed).
constexpr double shelterTime = 0.3;

Eigen::Vector3d vector3Of(const PackedVector& node) {
    return {double(node.x), double(node.y), double(node.z)};
}

double checkedLength(const WindField& field) {
    const double length = field.length();
    if (length > 0) return length;
    refuse<std::runtime_error>("the length of the wind field in WetCloth::air().field is ", length,
                               " m; return one above 0, infinity for a wind that is the same everywhere");
}

Eigen::Vector3d checkedVelocity(const WindField& field, const Eigen::Vector3d& position, double time) {
    Eigen::Vector3d velocity = field.velocity(position, time);
    if (velocity.norm() <= fastest) return velocity;
    refuse<std::runtime_error>("the wind field in WetCloth::air().field has a velocity of ", velocity,
                               " m/s at ", sixDigits(position), " m and ", sixDigits(time),
                               " s; return finite ones of at most 10000 m/s");
}

// Neighbours of each node, in the order of its triangles.
CompressedRows<std::size_t> neighboursOf(const ClothMesh& mesh) {
    return {mesh.size(), [&](const auto& add) {
                for (const auto& triangle : mesh.triangles)
                    for (std::size_t corner = 0; corner < 3; ++corner)
                        for (std::size_t on = 1; on < 3; ++on)
                            add(static_cast<std::size_t>(triangle[corner]),
                                static_cast<std::size_t>(triangle[(corner + on) % 3]));
            }};
}

}  // namespace

WindAtNodes::WindAtNodes(const ClothMesh& mesh) : velocities_(mesh.size(), PackedVector{0, 0, 0, 0}) {
    for (const double area : mesh.areas) areas_.push_back(float(area));
    makePatches(mesh);
}

// Each patch grows around a node that does not yet belong to a patch.
void WindAtNodes::makePatches(const ClothMesh& mesh) {
    const auto neighbours = neighboursOf(mesh);
    const std::size_t max = std::max(minNodes, (mesh.size() + maxPatches - 1) / maxPatches);
    std::vector<char> isTaken(mesh.size(), 0);
    for (std::size_t first = 0; first < mesh.size(); ++first) {
        if (isTaken[first]) continue;
        std::vector<std::size_t> nodes = {first};
        isTaken[first] = 1;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            for (const std::size_t neighbour : neighbours[nodes[i]]) {
                if (isTaken[neighbour] || nodes.size() == max) continue;
                isTaken[neighbour] = 1;
                nodes.push_back(neighbour);
            }
        const std::size_t middle = nodes[nodes.size() / 2];
        patches_.push_back({std::move(nodes), middle});
    }
}

void WindAtNodes::evaluate(const Air& air, const Moment& moment) {
    if (air.field) {
        readField(air, moment);
        interpolate(moment.pose);
    } else {
        fill(air.wind);
    }
    if (!(air.shelterLength > 0) && !isSheltered_) return;
    askUpwind(air.shelterLength, moment);
    shelter(moment.step);
}

void WindAtNodes::fill(const Eigen::Vector3d& wind) {
    if (isUniform_ && wind == mean_) return;
    std::fill(velocities_.begin(), velocities_.end(), packed(wind));
    mean_ = wind;
    isUniform_ = true;
}

// Spans the sheet. The lattice never becomes coarser again, because each change alters the interpolated wind
// slightly.
void WindAtNodes::layLattice(double spacing, const Pose& pose) {
    low_ = arrayOf(pose.relativePositions[0]);
    Eigen::Array4f high = low_;
    for (std::size_t n = 1; n < velocities_.size(); ++n) {
        low_ = low_.min(arrayOf(pose.relativePositions[n]));
        high = high.max(arrayOf(pose.relativePositions[n]));
    }
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        std::size_t& points = points_[static_cast<std::size_t>(axis)];
        const float extent = high[axis] - low_[axis];
        const double wanted = std::min(std::ceil(double(extent) / spacing), double(maxPoints - 1));
        points = std::max(points, static_cast<std::size_t>(wanted) + 1);
        distance_[axis] = extent > 0 ? extent / float(points - 1) : 1;
    }
}

void WindAtNodes::readField(const Air& air, const Moment& moment) {
    layLattice(checkedLength(*air.field), moment.pose);
    std::size_t point = 0;
    for (std::size_t k = 0; k < points_[2]; ++k)
        for (std::size_t j = 0; j < points_[1]; ++j)
            for (std::size_t i = 0; i < points_[0]; ++i) {
                const Eigen::Array4f position =
                    low_ + distance_ * Eigen::Array4f(float(i), float(j), float(k), 0);
                const Eigen::Vector3d where = moment.origin + vector3Of(nodeOf(position));
                lattice_[point++] = packed(air.wind + checkedVelocity(*air.field, where, moment.time));
            }
}

void WindAtNodes::interpolate(const Pose& pose) {
    const Eigen::Array4f perDistance = 1 / distance_;
    Eigen::Array4i last = Eigen::Array4i::Zero();  // cell along each axis
    for (std::size_t axis = 0; axis < 3; ++axis)
        last[static_cast<Eigen::Index>(axis)] = static_cast<int>(points_[axis]) - 2;
    const std::size_t row = points_[0], layer = points_[0] * points_[1];
    for (std::size_t n = 0; n < velocities_.size(); ++n) {
        const Eigen::Array4f at = (arrayOf(pose.relativePositions[n]) - low_) * perDistance;
        const Eigen::Array4i cell = at.cast<int>().min(last);
        const Eigen::Array4f rest = at - cell.cast<float>();
        const PackedVector* const corner =
            &lattice_[static_cast<std::size_t>(cell[0]) + static_cast<std::size_t>(cell[1]) * row +
                      static_cast<std::size_t>(cell[2]) * layer];
        const auto between = [](const Eigen::Array4f& a, const Eigen::Array4f& b, float fraction) {
            return Eigen::Array4f(a + (b - a) * fraction);
        };
        const auto alongRow = [&](std::size_t start) {
            return between(arrayOf(corner[start]), arrayOf(corner[start + 1]), rest[0]);
        };
        const Eigen::Array4f near = between(alongRow(0), alongRow(row), rest[1]),
                             far = between(alongRow(layer), alongRow(layer + row), rest[1]);
        velocities_[n] = nodeOf(between(near, far, rest[2]));
    }
    isUniform_ = false;
    average();
}

void WindAtNodes::average() {
    Eigen::Array4d sum = Eigen::Array4d::Zero();
    double area = 0;
    for (std::size_t n = 0; n < velocities_.size(); ++n) {
        sum += (arrayOf(velocities_[n]) * areas_[n]).cast<double>();
        area += double(areas_[n]);
    }
    mean_ = area > 0 ? Eigen::Vector3d(sum.head<3>().matrix() / area) : Eigen::Vector3d::Zero();
}

void WindAtNodes::askUpwind(double length, const Moment& moment) {
    if (!(length > 0)) {
        for (Patch& patch : patches_) patch.passing = 1;
        return;
    }
    for (std::size_t asked = 0; asked < std::min(raysPerStep, patches_.size()); ++asked) {
        Patch& patch = patches_[nextRay_];
        nextRay_ = (nextRay_ + 1) % patches_.size();
        const Eigen::Vector3d wind = vector3Of(velocities_[patch.middle]);
        const Eigen::Vector3d from = moment.origin + vector3Of(moment.pose.relativePositions[patch.middle]);
        const double speed = wind.norm();
        patch.passing = 1;
        if (!(speed > 0)) continue;
        SolidRay ray(toBullet(from), toBullet(from - wind * (length / speed)));
        moment.world.rayTest(ray.m_rayFromWorld, ray.m_rayToWorld, ray);
        if (ray.hasHit()) patch.passing = double(ray.m_closestHitFraction);
    }
}

void WindAtNodes::shelter(double step) {
    constexpr double allButAll = 0.9999;
    const double towards = 1 - std::exp(-step / shelterTime);
    isSheltered_ = false;
    for (Patch& patch : patches_) {
        patch.fraction += (patch.passing - patch.fraction) * towards;
        if (patch.passing >= 1 && patch.fraction > allButAll) patch.fraction = 1;
        if (!(patch.fraction < 1)) continue;
        isSheltered_ = true;
        const float fraction = float(patch.fraction);
        for (const std::size_t node : patch.nodes)
            velocities_[node] = nodeOf(arrayOf(velocities_[node]) * fraction);
    }
    if (!isSheltered_) return;
    isUniform_ = false;
    average();
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
