// How rain wets ground that is too wide to follow drop by drop.
#pragma once

#include <Eigen/Geometry>

#include "viewer/picture/picture.h"

namespace drench::demo {

// The mean of what WetSpots show, over ground that rain falls on evenly. Only for the eye.
class OpenGround {
  public:
    // Share of the area of a wet spot that lies within its uneven outline (assumed).
    static constexpr double withinOutline = 0.65;

    // Adds rain, kg/m2, at least 0; `followed` is the region in which each drop is followed.
    void rain(double massPerArea, const Eigen::AlignedBox3d& followed);
    // Takes so much water from all of it, kg/m2.
    void dry(double massPerArea);
    void show(viewer::Picture& picture) const;

  private:
    double covered_ = 0;      // share that drops have met
    double massPerArea_ = 0;  // kg/m2, over all of it
    Eigen::AlignedBox3d followed_;
};

}  // namespace drench::demo
