// Converts values for shaders, and checks whether they can be drawn; no OpenGL.
#pragma once

#include <Eigen/Geometry>
#include <array>

namespace drench::viewer {

constexpr float farthest = 1e5f;  // metres

inline bool isDrawable(const Eigen::Vector3f& point) {
    return point.allFinite() && point.cwiseAbs().maxCoeff() <= farthest;
}

inline bool isDrawable(float size) {
    return size > 0.0f && size <= farthest;
}

inline std::array<float, 4> packed(const Eigen::Vector3f& vector, float last) {
    return {vector.x(), vector.y(), vector.z(), last};
}

inline std::array<float, 4> packed(const Eigen::Quaternionf& turn) {
    return {turn.x(), turn.y(), turn.z(), turn.w()};
}

}  // namespace drench::viewer
