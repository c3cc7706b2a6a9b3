#include "effects/wet_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "checks/checks.h"
#include "world/angles.h"
#include "world/vectors.h"

namespace drench::demo {

namespace {

constexpr double runsTogether = 0.4;  // share of a place's radius within which new water joins it
constexpr double darkUntil = 0.35;    // of the layer; below it the place fades

double discRadius(double area) {
    return std::sqrt(area / pi);
}

double areaFor(double mass) {
    return std::min(mass / WetPlaces::layer, pi * WetPlaces::largestRadius * WetPlaces::largestRadius);
}

}  // namespace

double WetPlaces::wetnessOf(double massPerArea) {
    return std::min(1.0, massPerArea / (darkUntil * layer));
}

WetPlaces::WetPlaces(std::size_t max) : max_(max) {
    if (max < 1) refuse("there is room for ", max, " wet places; give at least 1");
}

/// The place on a body whose middle is nearest, if that is within so many of its radii or within `reach`, m.
WetPlaces::Place* WetPlaces::nearest(const btCollisionObject& body, const Eigen::Vector3d& inBody,
                                     double perRadius, double reach) {
    Place* found = nullptr;
    double min = std::numeric_limits<double>::infinity();
    for (Place& place : places_) {
        if (place.body != &body) continue;
        const double away2 = (place.inBody - inBody).squaredNorm();
        const double near2 = std::max(perRadius * perRadius * place.area / pi, reach * reach);
        if (away2 >= std::min(min, near2)) continue;
        min = away2;
        found = &place;
    }
    return found;
}

void WetPlaces::wet(const btCollisionObject& body, const Eigen::Vector3d& place, double mass, float outline) {
    if (!(mass > 0)) return;
    const Eigen::Vector3d inBody = toEigen(body.getWorldTransform().invXform(toBullet(place)));
    // The less room there is for other places, the farther water goes to join one.
    const double room = 1 - double(places_.size()) / double(max_);
    const double reach = largestRadius * std::pow(std::clamp(1 - 2 * room, 0.0, 1.0), 2);
    if (Place* const old = nearest(body, inBody, runsTogether, reach)) {
        old->inBody += (inBody - old->inBody) * mass / (old->mass + mass);
        old->mass += mass;
        old->area = std::max(old->area, areaFor(old->mass));
        old->mass = std::min(old->mass, maxLayers * layer * old->area);
        return;
    }
    if (places_.size() >= max_) {
        const auto driest = std::min_element(
            places_.begin(), places_.end(),
            [](const Place& a, const Place& b) { return a.mass * b.area < b.mass * a.area; });
        places_.erase(driest);
    }
    const double area = areaFor(mass);
    places_.push_back({&body, inBody, std::min(mass, maxLayers * layer * area), area, outline});
}

void WetPlaces::dry(double massPerArea) {
    for (Place& place : places_) place.mass -= massPerArea * place.area;
    places_.erase(
        std::remove_if(places_.begin(), places_.end(), [](const Place& place) { return !(place.mass > 0); }),
        places_.end());
}

void WetPlaces::keepOnlyIn(const btCollisionWorld& world) {
    const btCollisionObjectArray& objects = world.getCollisionObjectArray();
    std::set<const btCollisionObject*> there;
    for (int i = 0; i < objects.size(); ++i) there.insert(objects[i]);
    places_.erase(std::remove_if(places_.begin(), places_.end(),
                                 [&](const Place& place) { return there.count(place.body) == 0; }),
                  places_.end());
}

double WetPlaces::mass() const {
    double sum = 0;
    for (const Place& place : places_) sum += place.mass;
    return sum;
}

void WetPlaces::show(viewer::Picture& picture) const {
    for (const Place& place : places_) {
        const btTransform& frame = place.body->getWorldTransform();
        viewer::WetPatch patch;
        patch.centre = pictureVector(frame * toBullet(place.inBody));
        patch.radius = float(discRadius(place.area));
        patch.wetness = float(wetnessOf(place.mass / place.area));
        patch.orientation = toEigen(frame.getRotation()).cast<float>();
        patch.outline = place.outline;
        picture.patches.push_back(patch);
    }
}

}  // namespace drench::demo
