// Packed nodes as Eigen's arrays of four, which the processor takes at once.
#pragma once

#include <Eigen/Core>

#include "bullet/small_steps/small_step_kernels.h"

namespace drench {

inline Eigen::Map<const Eigen::Array4f, Eigen::Aligned16> arrayOf(const MovingNode& node) {
    return Eigen::Map<const Eigen::Array4f, Eigen::Aligned16>(&node.x);
}

inline MovingNode nodeOf(const Eigen::Array4f& array) {
    return {array[0], array[1], array[2], array[3]};
}

inline MovingNode packed(const Eigen::Vector3d& vector) {
    return {float(vector.x()), float(vector.y()), float(vector.z()), 0};
}

}  // namespace drench
