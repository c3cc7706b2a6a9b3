#include "viewer/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "checks/text.h"

namespace drench::viewer {

namespace {

template <typename Value>
void require(bool holds, const char* field, const Value& value) {
    if (!holds)
        throw std::runtime_error(textOf("viewer: camera ", field, " is ", value,
                                        ", out of range or not finite; set a value as picture.h describes"));
}

}  // namespace

Eigen::Vector3f Camera::forward() const {
    return {-std::cos(pitch) * std::sin(yaw), -std::sin(pitch), -std::cos(pitch) * std::cos(yaw)};
}

Eigen::Vector3f Camera::right() const {
    return {std::cos(yaw), 0.0f, -std::sin(yaw)};
}

Eigen::Vector3f Camera::eye() const {
    return target - distance * forward();
}

Eigen::Matrix4f Camera::view() const {
    Eigen::Matrix3f rotation;
    rotation.row(0) = right();
    rotation.row(1) = right().cross(forward());
    rotation.row(2) = -forward();
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
    matrix.topLeftCorner<3, 3>() = rotation;
    matrix.topRightCorner<3, 1>() = -(rotation * eye());
    return matrix;
}

Eigen::Matrix4f Camera::projection(float aspect) const {
    const float height = std::tan(verticalFieldOfView / 2.0f);
    const float nearest = nearPlane();
    const float farthest = farPlane();
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Zero();
    matrix(0, 0) = 1.0f / (height * aspect);
    matrix(1, 1) = 1.0f / height;
    matrix(2, 2) = -(farthest + nearest) / (farthest - nearest);
    matrix(2, 3) = -2.0f * farthest * nearest / (farthest - nearest);
    matrix(3, 2) = -1.0f;
    return matrix;
}

// With a depth of 24 bits these planes resolve 0.01 mm at the target of a camera 5 m away.
float Camera::nearPlane() const {
    return 0.04f * distance;
}

float Camera::farPlane() const {
    return std::max(60.0f * distance, 300.0f);
}

void Camera::check() const {
    constexpr float quarterTurn = 1.5707963f;
    require(target.allFinite(), "target", target);
    require(distance > 0.0f && std::isfinite(distance), "distance", distance);
    require(std::isfinite(yaw), "yaw", yaw);
    require(std::abs(pitch) < quarterTurn, "pitch", pitch);
    require(verticalFieldOfView > 0.0f && verticalFieldOfView < 2.0f * quarterTurn, "verticalFieldOfView",
            verticalFieldOfView);
}

}  // namespace drench::viewer
