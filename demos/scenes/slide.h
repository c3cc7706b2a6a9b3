// A dry, a damp and a soaked sheet on slopes.
#pragma once

#include <string>
#include <vector>

#include "stage/staged_scene.h"

namespace drench::demo {

/// Three sheets of the same cloth, 0.5 m square, lie on smooth slopes of 20 degrees side by side: from the left dry,
/// damp (pores 60 % full), and soaked, with so much water on the faces that it lubricates.
class Slide final : public StagedScene {
  public:
    explicit Slide(const SceneOptions& options);

    std::string status() const override { return timeText(2); }
    std::vector<Column> columns() const override;
    std::vector<double> row() const override;

  private:
    double slid(std::size_t lane) const;
    double dryTheory(double time) const;
    void measure() override;
    void annotate(viewer::Picture& picture) const override;
    std::string remarks() const override;
    void check(std::vector<std::string>& list) const override;

    std::vector<double> starts_;  // of each sheet's middle, along the slope, m
    double measuredDry_ = 0;      // m that the dry sheet slid until `measuredAt`
};

}  // namespace drench::demo
