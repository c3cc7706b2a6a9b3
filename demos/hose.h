// A hose in the user's hand.
#pragma once

#include <drench/drench.h>

#include <memory>
#include <vector>

#include "graspable.h"

namespace drench::demo {

/// Where water leaves a hose.
struct Nozzle {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();      ///< m
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< of unit length
    double halfAngle = 0.08;                               ///< of its cone, rad
    double rate = 0.1;                                     ///< kg/s of the sheet's own time
    double speed = 6;                                      ///< of the water, m/s
};

/// Sprays water at sheets, in the sheets' own time however fast their water runs, in an account named "hose".
class Hose {
  public:
    /// Sprays at all of these sheets in the next frame of so many seconds.
    void spray(const std::vector<Graspable>& sheets, const Nozzle& nozzle, double frameTime);

  private:
    struct Stream;
    class StreamSource;

    Stream& streamTo(WetCloth& cloth);

    std::vector<std::weak_ptr<Stream>> streams_;  // end with their sheets
};

}  // namespace drench::demo
