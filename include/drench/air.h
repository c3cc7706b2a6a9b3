// The air around a sheet.
#pragma once

#include <Eigen/Core>
#include <memory>

namespace drench {

class WindField;  // see wind.h

/// Weather around one sheet. May be changed between steps.
struct Air {
    /// Velocity of the undisturbed air, m/s; at most 1e4; default 0.
    Eigen::Vector3d wind = Eigen::Vector3d::Zero();
    double temperature = 20;  ///< degrees Celsius; 0 to 60; default 20 (standard climate)
    double humidity = 0.65;   ///< relative humidity; 0 to 1; default 0.65 (standard climate)

    /// Factor on the vapour exchange between cloth and air, dimensionless; 0 (sealed, nothing dries) to 1 (free);
    /// default 1.
    double vapourExchange = 1;

    /// Wind that varies in space and time, such as `Gusts`; its velocity is added to `wind`; default none.
    /// Its time is the body's time since its WetCloth was made. It is evaluated at up to 6 x 6 x 6 points around
    /// the sheet and interpolated between them. Several sheets may share one field.
    std::shared_ptr<const WindField> field = nullptr;

    /// Length of the wind shadow behind a solid body, m; 0 (no shelter) to 1000; default 0. A few times the body's
    /// height is realistic. Directly behind the body there is no wind; the wind grows linearly with the distance
    /// and has its full speed from this length on. Changes take effect with a time constant of about 0.3 s (both
    /// assumed). The sheet is divided into patches of 16 nodes, or of 1/256 of its nodes if that is more; each step
    /// casts one ray from the middle of each of 32 patches, in turn. Bodies narrower than a patch may be missed.
    /// Soft bodies, and objects without contact response (triggers), give no shelter.
    double shelterLength = 0;
};

}  // namespace drench
