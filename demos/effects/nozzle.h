// A spray nozzle, for the pictures.
#pragma once

#include <Eigen/Core>

namespace drench::demo {

// A nozzle that spreads water over a cone.
struct Nozzle {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();    // m
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // any length above 0
    double halfAngle = 0.2;                                // rad, of the cone; 0 to pi/2
    double speed = 6;                                      // of the drops, m/s; above 0
    double rate = 0.02;                                    // kg/s, at least 0
};

}  // namespace drench::demo
