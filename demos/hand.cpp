#include "hand.h"

#include <algorithm>
#include <cmath>

#include "angles.h"
#include "scene.h"

namespace drench::demo {

namespace {

constexpr double nozzleDistance = 1.2;  // m, from what the hose is held at
constexpr double farthestAim = 8;       // m, from the eye, where it is held at nothing

/// Beside and below the line of sight, so that the water is seen from the side.
Nozzle nozzleFor(const Pointer& pointer, double aimDistance) {
    const Eigen::Vector3d sight = pointer.ray.direction.cast<double>();
    const Eigen::Vector3d eye = pointer.ray.origin.cast<double>();
    const Eigen::Vector3d aim = eye + aimDistance * sight;
    const Eigen::Vector3d right = pointer.forward.cast<double>().cross(Eigen::Vector3d::UnitY()).normalized();
    const double distance = std::min(nozzleDistance, 0.6 * aimDistance);
    Nozzle nozzle;
    nozzle.halfAngle = 0.08;
    nozzle.rate = 0.1;
    nozzle.place = aim - distance * (0.8 * sight - 0.45 * right + 0.4 * Eigen::Vector3d::UnitY());
    nozzle.direction = (aim - nozzle.place).normalized();
    return nozzle;
}

}  // namespace

void Hand::act(const std::vector<Graspable>& sheets, const Pointer& pointer, double frameTime) {
    nozzle_.reset();
    drag(sheets, pointer, frameTime);
    if (pointer.pressed && pointer.tool == Tool::hose) spray(sheets, pointer, frameTime);
    if (pointer.pressed && pointer.tool == Tool::towel)
        if (const auto hit = firstHit(sheets, pointer.ray))
            dabDry(*hit->sheet.cloth, *hit->sheet.body, hit->point, frameTime);
    pressed_ = pointer.pressed;
}

void Hand::forget() {
    grasp_.reset();
    nozzle_.reset();
    hose_ = Hose();
}

void Hand::drag(const std::vector<Graspable>& sheets, const Pointer& pointer, double frameTime) {
    if (grasp_ && !grasp_->holdsOneOf(sheets)) grasp_.reset();
    const bool drags = pointer.pressed && pointer.tool == Tool::hand;
    if (drags && !pressed_ && !grasp_)
        if (const auto hit = firstHit(sheets, pointer.ray)) grasp_.emplace(*hit, pointer);
    if (!grasp_) return;
    if (drags) return grasp_->follow(pointer, frameTime);
    grasp_->release();
    grasp_.reset();
}

void Hand::spray(const std::vector<Graspable>& sheets, const Pointer& pointer, double frameTime) {
    const auto hit = firstHit(sheets, pointer.ray);
    nozzle_ = nozzleFor(pointer, hit ? hit->distance : farthestAim / 2);
    flight_ = hit ? (Eigen::Vector3d(hit->point.x(), hit->point.y(), hit->point.z()) - nozzle_->place).norm()
                  : farthestAim / 2;
    ++frames_;
    hose_.spray(sheets, *nozzle_, frameTime);
}

/// Drops one behind the other, at places in the cone that look like chance and are the same in each run.
void Hand::show(viewer::Picture& picture) const {
    if (!nozzle_) return;
    const Eigen::Vector3d along = nozzle_->direction.normalized();
    const Eigen::Vector3d side = along.unitOrthogonal(), other = along.cross(side);
    const Eigen::Vector3d grip = nozzle_->place - 0.22 * along - 0.06 * Eigen::Vector3d::UnitY();
    picture.rods.push_back({(nozzle_->place - 0.05 * along).cast<float>(), nozzle_->place.cast<float>(),
                            0.012f, Eigen::Vector3f(0.55f, 0.42f, 0.15f)});
    picture.rods.push_back({grip.cast<float>(), (nozzle_->place - 0.06 * along).cast<float>(), 0.018f,
                            Eigen::Vector3f(0.04f, 0.10f, 0.05f)});
    constexpr int drops = 260;
    constexpr double golden = 0.6180339887, plastic = 0.7548776662, plasticSquared = 0.5698402910;
    const double advance = nozzle_->speed * Scene::frameTime * frames_;
    for (int i = 1; i <= drops; ++i) {
        const auto part = [&](double step) { return i * step - std::floor(i * step); };
        const double flown = std::fmod(part(golden) * flight_ + advance, flight_);
        const double angle = 2 * pi * part(plastic);
        const double offset = flown * std::tan(nozzle_->halfAngle) * std::sqrt(part(plasticSquared));
        const Eigen::Vector3d spread = offset * (std::cos(angle) * side + std::sin(angle) * other);
        picture.drops.push_back({(nozzle_->place + flown * along + spread).cast<float>(),
                                 (nozzle_->speed * along).cast<float>(), 0.0022f});
    }
}

void dabDry(WetCloth& cloth, const btSoftBody& body, const btVector3& point, double time) {
    constexpr double radius = 0.06;                   // m
    constexpr double filmTime = 0.1, poreTime = 0.5;  // s, time constants
    Supply& towel = cloth.account("towel");
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        if (double((body.m_nodes[n].m_x - point).length()) > radius) continue;
        const auto node = static_cast<std::size_t>(n);
        const Moisture& water = cloth.moisture();
        if (!(water.area(node) > 0)) continue;
        towel.takeFilm(node, water.filmMass()[node] * -std::expm1(-time / filmTime));
        towel.takePores(node, water.poreMass()[node] * -std::expm1(-time / poreTime));
    }
}

}  // namespace drench::demo
