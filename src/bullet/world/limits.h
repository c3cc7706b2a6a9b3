// Limits of valid states; beyond them single precision and Bullet's trees fail.
#pragma once

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

constexpr double farthestPosition =
    1e7;                             // m, along an axis; Bullet counts the voxels up to there with an int
constexpr double fastestNode = 1e6;  // m/s, along an axis
constexpr double strongestGravity = 1e4;  // m/s2

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
