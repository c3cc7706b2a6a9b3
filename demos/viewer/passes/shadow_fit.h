// Fits the shadow map to the objects of a picture; no OpenGL.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace drench::viewer {

// Orthographic view from the sun on everything that casts a shadow.
struct ShadowFit {
    // World to the clip space of the shadow map, 4 x 4.
    Eigen::Matrix4f clipFromWorld;
    // Edge length of the square that the map covers, m.
    float side;
    // Edge length of a texel of the map, m.
    float texel;
    // Distance between the near and the far plane, m.
    float depth;
};

// Fits the view to points (world, finite) seen from the unit direction towardsSun. The view moves in steps of
// whole texels of a map of `resolution` texels, so that shadow edges do not flicker while the cloth moves.
ShadowFit fitShadow(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& towardsSun,
                    int resolution);

}  // namespace drench::viewer
