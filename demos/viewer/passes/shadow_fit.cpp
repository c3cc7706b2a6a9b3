#include "viewer/passes/shadow_fit.h"

#include <Eigen/Geometry>
#include <cmath>

namespace drench::viewer {

namespace {

// The rows are the right, up and sun directions of the map.
Eigen::Matrix3f sunRotation(const Eigen::Vector3f& towardsSun) {
    const Eigen::Vector3f helper =
        std::abs(towardsSun.y()) < 0.95f ? Eigen::Vector3f::UnitY() : Eigen::Vector3f::UnitZ();
    const Eigen::Vector3f right = helper.cross(towardsSun).normalized();
    Eigen::Matrix3f rotation;
    rotation.row(0) = right;
    rotation.row(1) = towardsSun.cross(right);
    rotation.row(2) = towardsSun;
    return rotation;
}

Eigen::AlignedBox3f boundsSeenFromSun(const std::vector<Eigen::Vector3f>& points,
                                      const Eigen::Matrix3f& rotation) {
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& point : points) box.extend(Eigen::Vector3f(rotation * point));
    if (box.isEmpty()) box.extend(Eigen::Vector3f(Eigen::Vector3f::Zero()));
    return box;
}

}  // namespace

ShadowFit fitShadow(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& towardsSun,
                    int resolution) {
    constexpr float margin = 0.2f;
    constexpr float sizeStep = 0.5f;
    const Eigen::Matrix3f rotation = sunRotation(towardsSun);
    const Eigen::AlignedBox3f box = boundsSeenFromSun(points, rotation);
    const float widest = box.sizes().head<2>().maxCoeff() + 2.0f * margin;
    const float side = sizeStep * std::ceil(widest / sizeStep);
    const float texel = side / static_cast<float>(resolution);
    Eigen::Vector3f centre = box.center();
    centre.x() = texel * std::round(centre.x() / texel);
    centre.y() = texel * std::round(centre.y() / texel);

    const float depth = box.sizes().z() + 2.0f * margin;
    // OpenGL's depth grows away from the sun.
    const Eigen::Vector3f scale(2.0f / side, 2.0f / side, -2.0f / depth);
    ShadowFit fit{Eigen::Matrix4f::Identity(), side, texel, depth};
    fit.clipFromWorld.topLeftCorner<3, 3>() = scale.asDiagonal() * rotation;
    fit.clipFromWorld.topRightCorner<3, 1>() = -scale.cwiseProduct(centre);
    return fit;
}

}  // namespace drench::viewer
