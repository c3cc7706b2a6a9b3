// Which part of the world the sun's shadow map covers; plain arithmetic, no OpenGL.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace drench::viewer {

// The sun's square view of everything that casts a shadow.
struct ShadowFit {
    // World to the clip space of the shadow map, 4 x 4.
    Eigen::Matrix4f clipFromWorld;
    // Side of the square that the map covers, metres.
    float side;
    // Side of one pixel of the map, metres.
    float texel;
    // Distance between the near and the far plane, metres.
    float depth;
};

// Fits the view round points (world, finite) seen from the unit direction towardsSun. The view moves in steps
// of whole texels of a map of `resolution` pixels, so that shadow edges do not crawl while the cloth moves.
ShadowFit fitShadow(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& towardsSun,
                    int resolution);

}  // namespace drench::viewer
