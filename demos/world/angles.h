// Angles, for scenes and what they measure.
#pragma once

namespace drench::demo {

inline constexpr double pi = 3.14159265358979323846;

constexpr double degrees(double radians) {
    return radians * 180 / pi;
}

constexpr double radians(double degrees) {
    return degrees * pi / 180;
}

}  // namespace drench::demo
