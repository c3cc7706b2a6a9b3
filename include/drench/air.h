// The air around a sheet.
#pragma once

#include <Eigen/Core>

namespace drench {

/// Weather as one sheet feels it; may be changed between steps.
struct Air {
    Eigen::Vector3d wind = Eigen::Vector3d::Zero();  ///< velocity of the undisturbed air, m/s; default still
    double temperature = 20;                         ///< degrees Celsius, 0 to 60; default standard climate
    double humidity = 0.65;                          ///< relative, 0 to 1; default standard climate

    /// How freely vapour passes between cloth and air, 1; 0 (as if wrapped: nothing dries) to 1, the default.
    double vapourExchange = 1;
};

}  // namespace drench
