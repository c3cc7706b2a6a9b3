// Wetting of ground by rain where the area is too large to simulate each drop.
#pragma once

#include <Eigen/Geometry>

#include "viewer/picture/picture.h"

namespace drench::demo {

// The mean of what WetSpots show on ground under uniform rain. Only for pictures.
class OpenGround {
  public:
    // Fraction of the area of a wet spot that lies within its uneven outline (assumed).
    static constexpr double withinOutline = 0.65;

    // Adds rain, kg/m2, at least 0; `followed` is the region in which each drop is simulated.
    void rain(double massPerArea, const Eigen::AlignedBox3d& followed);
    // Removes this much water from all of the ground, kg/m2.
    void dry(double massPerArea);
    void show(viewer::Picture& picture) const;

  private:
    double covered_ = 0;      // fraction of the ground that drops have hit
    double massPerArea_ = 0;  // mean over all of the ground, kg/m2
    Eigen::AlignedBox3d followed_;
};

}  // namespace drench::demo
