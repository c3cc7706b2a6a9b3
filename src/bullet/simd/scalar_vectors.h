// Functions that the scalar inner loops share.
#pragma once

#include <cmath>
#include <cstddef>

#include "bullet/simd/nodes.h"

namespace drench {

template <typename Node>
void addTo(Node& node, float x, float y, float z, float by) {
    node.x += x * by;
    node.y += y * by;
    node.z += z * by;
}

// The unit normal of a triangle. @return twice the area
template <typename Node>
float normalOf(float* normal, const Node& a, const Node& b, const Node& c) {
    constexpr float tiny = 1e-30f;
    const float u[3] = {b.x - a.x, b.y - a.y, b.z - a.z}, v[3] = {c.x - a.x, c.y - a.y, c.z - a.z};
    for (std::size_t axis = 0; axis < 3; ++axis)
        normal[axis] = u[(axis + 1) % 3] * v[(axis + 2) % 3] - u[(axis + 2) % 3] * v[(axis + 1) % 3];
    const float length =
        std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2] + tiny);
    for (std::size_t axis = 0; axis < 3; ++axis) normal[axis] /= length;
    return length;
}

}  // namespace drench
