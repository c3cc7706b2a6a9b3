// Where the time of a sheet's steps goes.
#pragma once

#include <cstdint>

namespace drench {

/// Running totals of computing time of one sheet since its WetCloth was made, s of a steady clock. What a
/// frame took is the difference between two of these; measuring it takes about a microsecond a substep. Of
/// what sheets of a world have in common each has an equal part.
struct StepTimes {
    double supply = 0;    ///< sources bring their water
    double water = 0;     ///< drying, soaking in, wicking, running down, dripping
    double laws = 0;      ///< masses and stiffness follow from the water
    double air = 0;       ///< wind at the nodes, and what air and water push
    double contacts = 0;  ///< with solids and other sheets; without small steps only friction and cling
    double solver = 0;    ///< links, bending and motion in small steps; 0 where Bullet's own solver does that
    std::int64_t substeps = 0;  ///< Bullet's, so far
};

}  // namespace drench
