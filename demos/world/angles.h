// Conversions of angles.
#pragma once

#include "cloth/constants.h"

namespace drench::demo {

constexpr double degrees(double radians) {
    return radians * 180 / pi;
}

constexpr double radians(double degrees) {
    return degrees * pi / 180;
}

}  // namespace drench::demo
