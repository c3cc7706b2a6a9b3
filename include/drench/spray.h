// A spray nozzle, as a source of water.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "drench/config.h"
#include "drench/source.h"

namespace drench {

/// A nozzle that distributes its water evenly over a cone. Each node inside the cone gets the fraction of the cone
/// that its projected area fills; water that misses the sheet is not supplied. A cone that is narrower than the
/// distance between nodes may pass between them. Solid bodies give shelter: each step tests `raysPerStep` nodes with
/// one ray each, cycling through all nodes. A result is kept until the node is tested again; a node that was never
/// tested counts as not sheltered. Cloth that lies on a node, such as the upper layer of a folded sheet, keeps the water
/// off where it covers it (with a SmallStepSolver).
class DRENCH_API Spray final : public Source {
  public:
    Eigen::Vector3d origin;     ///< position of the nozzle, m
    Eigen::Vector3d direction;  ///< of the axis of the cone; any length above 0
    double halfAngle = 0.2;  ///< between the axis and the surface of the cone, rad; 0.01 to 1.5; default 0.2
    double rate;             ///< water from the nozzle, kg/s; 0 to 1000
    double speed = 5;        ///< of the water, m/s; 0 to 100; default 5
    int raysPerStep = 64;    ///< nodes tested for shelter in each step; 1 to 1e6; default 64

    /// First values of `origin`, `direction` and `rate`.
    Spray(const Eigen::Vector3d& initialOrigin, const Eigen::Vector3d& initialDirection, double initialRate);
    std::string name() const override { return "spray"; }
    void supply(const SheetPose& sheet, double dt, Supply& supply) override;
    void save(StateWriter& writer) const override;
    void load(StateReader& reader) override;

  private:
    void distribute(const SheetPose& sheet);
    void askForShelter(const SheetPose& sheet);

    std::vector<char> sheltered_;
    std::vector<double> fractions_;  // fraction of the cone that each node fills
    std::size_t nextRay_ = 0;
};

}  // namespace drench
