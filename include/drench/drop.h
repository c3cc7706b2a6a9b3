// A drop of water that has let go of a sheet.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace drench {

/// Drops that fell from one place at one time.
struct Drop {
    Eigen::Vector3d position;  ///< where it let go, m
    Eigen::Vector3d velocity;  ///< that of the cloth there, m/s
    double mass;               ///< of each drop, kg
    std::int64_t count;        ///< how many fell together; more than one where water pours
    double time;               ///< of the body, since its WetCloth was made, s
    int node;                  ///< of the body that it fell from
};

}  // namespace drench
