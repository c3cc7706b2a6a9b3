#include "effects/wet_spots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "checks/checks.h"
#include "world/angles.h"
#include "world/vectors.h"

namespace drench::demo {

namespace {

constexpr double runsTogether = 0.4;  // fraction of a spot's radius within which new water joins it
constexpr double darkUntil = 0.35;    // fraction of the layer below which the spot fades

double discRadius(double area) {
    return std::sqrt(area / pi);
}

double areaFor(double mass) {
    return std::min(mass / WetSpots::layer, pi * WetSpots::largestRadius * WetSpots::largestRadius);
}

}  // namespace

double WetSpots::wetnessOf(double massPerArea) {
    return std::min(1.0, massPerArea / (darkUntil * layer));
}

WetSpots::WetSpots(std::size_t max) : max_(max) {
    if (max < 1) refuse("there is room for ", max, " wet spots; give at least 1");
}

// The spot on a body whose centre is nearest, if it is within `perRadius` times its radius or within `reach`,
// m.
WetSpots::Spot* WetSpots::nearest(const btCollisionObject& body, const Eigen::Vector3d& inBody,
                                  double perRadius, double reach) {
    Spot* found = nullptr;
    double min = std::numeric_limits<double>::infinity();
    for (Spot& spot : spots_) {
        if (spot.body != &body) continue;
        const double away2 = (spot.inBody - inBody).squaredNorm();
        const double near2 = std::max(perRadius * perRadius * spot.area / pi, reach * reach);
        if (away2 >= std::min(min, near2)) continue;
        min = away2;
        found = &spot;
    }
    return found;
}

void WetSpots::wet(const btCollisionObject& body, const Eigen::Vector3d& position, double mass,
                   float outline) {
    if (!(mass > 0)) return;
    const Eigen::Vector3d inBody = toEigen(body.getWorldTransform().invXform(toBullet(position)));
    // The fewer spots are free, the farther away water joins an existing one.
    const double room = 1 - double(spots_.size()) / double(max_);
    const double reach = largestRadius * std::pow(std::clamp(1 - 2 * room, 0.0, 1.0), 2);
    if (Spot* const old = nearest(body, inBody, runsTogether, reach)) {
        old->inBody += (inBody - old->inBody) * mass / (old->mass + mass);
        old->mass += mass;
        old->area = std::max(old->area, areaFor(old->mass));
        old->mass = std::min(old->mass, maxLayers * layer * old->area);
        return;
    }
    if (spots_.size() >= max_) {
        const auto driest = std::min_element(spots_.begin(), spots_.end(), [](const Spot& a, const Spot& b) {
            return a.mass * b.area < b.mass * a.area;
        });
        spots_.erase(driest);
    }
    const double area = areaFor(mass);
    spots_.push_back({&body, inBody, std::min(mass, maxLayers * layer * area), area, outline});
}

void WetSpots::dry(double massPerArea) {
    for (Spot& spot : spots_) spot.mass -= massPerArea * spot.area;
    spots_.erase(
        std::remove_if(spots_.begin(), spots_.end(), [](const Spot& spot) { return !(spot.mass > 0); }),
        spots_.end());
}

void WetSpots::keepOnlyIn(const btCollisionWorld& world) {
    const btCollisionObjectArray& objects = world.getCollisionObjectArray();
    std::set<const btCollisionObject*> there;
    for (int i = 0; i < objects.size(); ++i) there.insert(objects[i]);
    spots_.erase(std::remove_if(spots_.begin(), spots_.end(),
                                [&](const Spot& spot) { return there.count(spot.body) == 0; }),
                 spots_.end());
}

double WetSpots::mass() const {
    double sum = 0;
    for (const Spot& spot : spots_) sum += spot.mass;
    return sum;
}

void WetSpots::show(viewer::Picture& picture) const {
    for (const Spot& spot : spots_) {
        const btTransform& frame = spot.body->getWorldTransform();
        viewer::WetPatch patch;
        patch.centre = pictureVector(frame * toBullet(spot.inBody));
        patch.radius = float(discRadius(spot.area));
        patch.wetness = float(wetnessOf(spot.mass / spot.area));
        patch.orientation = toEigen(frame.getRotation()).cast<float>();
        patch.outline = spot.outline;
        picture.patches.push_back(patch);
    }
}

}  // namespace drench::demo
