// A hose in the user's hand.
#pragma once

#include <drench/drench.h>

#include <memory>
#include <vector>

#include "graspable.h"

namespace drench::demo {

/// What sprays water.
struct Nozzle {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();       ///< m
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< any length above 0
    double halfAngle = 0.2;                                ///< rad, of the cone; 0 to pi/2
    double speed = 6;                                      ///< of the drops, m/s; above 0
    double rate = 0.02;                                    ///< kg/s, at least 0
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
