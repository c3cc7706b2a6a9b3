// The colours that stand for values; plain arithmetic, no OpenGL.
#pragma once

#include <Eigen/Core>

namespace drench::viewer {

// Number of colours between which a shader may mix.
constexpr std::size_t colourStops = 9;

// Linear RGB for a share of the way from the lowest value to the highest, clamped to 0 to 1: from dark violet over
// teal to light yellow, in steps that look alike, ever lighter, so that it also reads without colour.
Eigen::Vector3f mappedColour(float fraction);

}  // namespace drench::viewer
