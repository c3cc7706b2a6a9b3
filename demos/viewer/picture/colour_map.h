// Colours for values; no OpenGL.
#pragma once

#include <Eigen/Core>

namespace drench::viewer {

// Number of colours, between which a shader interpolates.
constexpr std::size_t colourStops = 9;

// Linear RGB for a fraction of the range of values, clamped to 0 to 1: from dark violet over teal to light
// yellow, perceptually uniform and increasingly light, so that it is also readable without colour.
Eigen::Vector3f mappedColour(float fraction);

}  // namespace drench::viewer
