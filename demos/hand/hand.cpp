#include "hand/hand.h"

#include <algorithm>
#include <cmath>

namespace drench::demo {

namespace {

constexpr double nozzleDistance = 1.2;  // m, from the point at which the hose is aimed
constexpr double farthestAim = 8;       // m from the eye, if it is aimed at nothing

// Beside and below the line of sight, so that the water is visible from the side.
Nozzle nozzleFor(const Pointer& pointer, double aimDistance) {
    const Eigen::Vector3d sight = pointer.ray.direction.cast<double>();
    const Eigen::Vector3d eye = pointer.ray.origin.cast<double>();
    const Eigen::Vector3d aim = eye + aimDistance * sight;
    const Eigen::Vector3d right = pointer.forward.cast<double>().cross(Eigen::Vector3d::UnitY()).normalized();
    const double distance = std::min(nozzleDistance, 0.6 * aimDistance);
    Nozzle nozzle;
    nozzle.halfAngle = 0.08;
    nozzle.rate = 0.1;
    nozzle.position = aim - distance * (0.8 * sight - 0.45 * right + 0.4 * Eigen::Vector3d::UnitY());
    nozzle.direction = (aim - nozzle.position).normalized();
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

void Hand::drag(const std::vector<Graspable>& sheets, const Pointer& pointer, double frameTime) {
    if (grasp_ && !grasp_->holdsOneOf(sheets)) grasp_.reset();
    const bool drags = pointer.pressed && pointer.tool == Tool::hand;
    if (drags && !pressed_ && !grasp_)
        if (const auto hit = firstHit(sheets, pointer.ray)) grasp_.emplace(*hit, pointer);
    if (!grasp_) return;
    if (drags) return grasp_->follow(pointer, frameTime);
    letGo();
}

void Hand::letGo() {
    if (grasp_) grasp_->release();
    grasp_.reset();
}

void Hand::spray(const std::vector<Graspable>& sheets, const Pointer& pointer, double frameTime) {
    const auto hit = firstHit(sheets, pointer.ray);
    nozzle_ = nozzleFor(pointer, hit ? hit->distance : farthestAim / 2);
    hose_.spray(sheets, *nozzle_, frameTime);
}

// The stage draws the water in flight.
void Hand::show(viewer::Picture& picture) const {
    if (!nozzle_) return;
    const Eigen::Vector3d along = nozzle_->direction.normalized();
    const Eigen::Vector3d neck = nozzle_->position - 0.06 * along;
    const Eigen::Vector3d grip = neck - 0.16 * along - 0.06 * Eigen::Vector3d::UnitY();
    picture.rods.push_back(
        {neck.cast<float>(), nozzle_->position.cast<float>(), 0.012f, Eigen::Vector3f(0.55f, 0.42f, 0.15f)});
    picture.rods.push_back(
        {grip.cast<float>(), neck.cast<float>(), 0.018f, Eigen::Vector3f(0.04f, 0.10f, 0.05f)});
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
