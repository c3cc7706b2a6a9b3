// Packed nodes as Eigen arrays of four numbers, which the processor handles at once.
#pragma once

#include <Eigen/Core>

#include "bullet/simd/nodes.h"

namespace drench {

template <typename Node>
Eigen::Map<const Eigen::Array4f, Eigen::Aligned16> arrayOf(const Node& node) {
    return Eigen::Map<const Eigen::Array4f, Eigen::Aligned16>(&node.x);
}

inline PackedVector nodeOf(const Eigen::Array4f& array) {
    return {array[0], array[1], array[2], array[3]};
}

inline PackedVector packed(const Eigen::Vector3d& vector) {
    return {float(vector.x()), float(vector.y()), float(vector.z()), 0};
}

}  // namespace drench
