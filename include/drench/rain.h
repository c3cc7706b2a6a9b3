// Rain, as a source of water.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "drench/config.h"
#include "drench/source.h"

namespace drench {

/// Rain, in single drops. Each drop lands on a random node, with a probability proportional to the area of the node
/// projected along the direction of fall. One ray per drop, from the node opposite to that direction, tests whether a
/// solid body shelters the node. Cloth that lies on the node, such as the upper layer of a folded sheet, keeps the drop
/// off where it covers it (with a SmallStepSolver). The same seed gives the same drops on one platform. Cloth that is stretched to more
/// than 1.5 times its rest area catches no more than at 1.5 times.
class DRENCH_API Rain final : public Source {
  public:
    /// Rain on level ground, mm/h; 0 to 1000. Without gravity: on a surface perpendicular to `velocity`.
    double intensity;
    /// Velocity of the drops, m/s; speed 0.1 to 50, at least a hundredth of it downwards; default (0, -6.5, 0), the
    /// terminal velocity of 2 mm drops.
    Eigen::Vector3d velocity = {0, -6.5, 0};
    double shelterHeight = 30;  ///< length of the ray that finds a roof, m; 0 to 1000; default 30
    double dropMass = 4.2e-6;   ///< kg; 1e-8 to 1e-4; default 4.2e-6, a drop of 2 mm
    int maxDrops = 500;  ///< largest number per step, beyond which drops get heavier; 1 to 1e6; default 500

    /// @param initialIntensity  first value of `intensity`
    /// @param seed              of the random numbers; default 1
    explicit Rain(double initialIntensity, std::uint32_t seed = 1);
    std::string name() const override { return "rain"; }
    void supply(const SheetPose& sheet, double dt, Supply& supply) override;
    void save(StateWriter& writer) const override;
    void load(StateReader& reader) override;

  private:
    void sumAreas(const std::vector<double>& areas);

    std::mt19937 random_;
    std::vector<double> areaUpTo_;  // running sum of the nodes' rest areas, m2
};

}  // namespace drench
