// A wet brush, as a source of water.
#pragma once

#include <Eigen/Core>
#include <string>

#include "drench/config.h"
#include "drench/source.h"

namespace drench {

/// A wet brush: wets the cloth inside a sphere, most at its centre. Change `centre` to move it.
class DRENCH_API Brush final : public Source {
  public:
    Eigen::Vector3d centre;  ///< m
    double radius;           ///< m; 1e-4 to 100
    double rate;  ///< water at the centre, kg/s per m2 of cloth; 0 to 1000; falls to 0 at the radius

    /// First values of `centre`, `radius` and `rate`.
    Brush(const Eigen::Vector3d& initialCentre, double initialRadius, double initialRate)
        : centre(initialCentre), radius(initialRadius), rate(initialRate) {}
    std::string name() const override { return "brush"; }
    void supply(const SheetPose& sheet, double dt, Supply& supply) override;
};

}  // namespace drench
