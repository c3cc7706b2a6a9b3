// The air around a sheet.
#pragma once

#include <Eigen/Core>
#include <memory>

namespace drench {

class WindField;  // see wind.h

/// Weather as one sheet feels it; may be changed between steps.
struct Air {
    /// Velocity of the undisturbed air, m/s; at most 1e4, default still.
    Eigen::Vector3d wind = Eigen::Vector3d::Zero();
    double temperature = 20;  ///< degrees Celsius, 0 to 60; default standard climate
    double humidity = 0.65;   ///< relative, 0 to 1; default standard climate

    /// How freely vapour passes between cloth and air, 1; 0 (as if wrapped: nothing dries) to 1, the default.
    double vapourExchange = 1;

    /// What the air does from place to place and from moment to moment, such as `Gusts`; its velocity comes on
    /// top of `wind`. Its time is that of the body since its WetCloth was made. Read at up to 6 x 6 x 6 points
    /// around the sheet, between which it is interpolated. May be shared by sheets. Default none.
    std::shared_ptr<const WindField> field = nullptr;

    /// How far upwind a solid body keeps the wind off, m; 0, the default (nothing does), to 1000. A few times
    /// the body's height is natural. The share of the wind that passes grows evenly with the distance of the
    /// body, from nothing just behind it to all of it from this length on, and follows within some 0.3 s
    /// (both assumed). Patches of cloth, of 16 nodes or a 256th of the sheet, ask in turns, 32 in a step, each
    /// with one ray from its middle: things that are narrower than a patch may be missed. Other cloth, and
    /// things without contact response (triggers), keep nothing off.
    double shelterLength = 0;
};

}  // namespace drench
