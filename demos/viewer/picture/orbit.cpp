#include "viewer/picture/orbit.h"

#include <algorithm>
#include <cmath>

namespace drench::viewer {

void orbit(Camera& camera, float right, float down) {
    constexpr float radiansPerHeight = 3.0f;
    // Slightly below vertical, where yaw would be undefined.
    constexpr float steepest = 1.5f;
    constexpr float fullTurn = 6.2831853f;
    camera.yaw = std::remainder(camera.yaw - radiansPerHeight * right, fullTurn);
    camera.pitch = std::clamp(camera.pitch + radiansPerHeight * down, -steepest, steepest);
}

void pan(Camera& camera, float right, float down) {
    const float visibleHeight = 2.0f * camera.distance * std::tan(camera.verticalFieldOfView / 2.0f);
    const Eigen::Vector3f up = camera.right().cross(camera.forward());
    camera.target += visibleHeight * (down * up - right * camera.right());
}

void zoom(Camera& camera, float notches) {
    camera.distance = std::clamp(camera.distance * std::pow(0.88f, notches), 0.2f, 60.0f);
}

}  // namespace drench::viewer
