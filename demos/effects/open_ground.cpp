#include "effects/open_ground.h"

#include <algorithm>

#include "effects/wet_spots.h"

namespace drench::demo {

void OpenGround::rain(double massPerArea, const Eigen::AlignedBox3d& followed) {
    followed_ = followed;
    // Each drop wets a smaller area than its water would in one layer, and part of it where earlier drops
    // have landed.
    covered_ += (1 - covered_) * std::min(withinOutline * massPerArea / WetSpots::layer, 1.0);
    massPerArea_ = std::min(massPerArea_ + massPerArea, WetSpots::maxLayers * WetSpots::layer * covered_);
}

void OpenGround::dry(double massPerArea) {
    massPerArea_ -= massPerArea * covered_;
    if (!(massPerArea_ > 0)) covered_ = massPerArea_ = 0;
}

void OpenGround::show(viewer::Picture& picture) const {
    if (!(covered_ > 0)) return;
    const auto corner = [](const Eigen::Vector3d& position) {
        return Eigen::Vector2f(float(position.x()), float(position.z()));
    };
    picture.openGround.covered = float(covered_);
    picture.openGround.wetness = float(WetSpots::wetnessOf(massPerArea_ / covered_));
    picture.openGround.from = corner(followed_.min());
    picture.openGround.to = corner(followed_.max());
}

}  // namespace drench::demo
