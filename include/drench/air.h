// The air around a sheet.
#pragma once

#include <Eigen/Core>

namespace drench {

/// Weather as one sheet feels it; may be changed between steps.
struct Air {
    Eigen::Vector3d wind = Eigen::Vector3d::Zero();  ///< velocity of the undisturbed air, m/s; default still
};

}  // namespace drench
