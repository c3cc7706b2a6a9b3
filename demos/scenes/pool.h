// A sheet is dipped into a tank of water and lifted out.
#pragma once

#include <string>
#include <vector>

#include "stage/staged_scene.h"

namespace drench::demo {

/// A sheet, 0.6 m x 0.5 m, hangs from a bar by two clips. The bar lowers it into a tank until all of it is under
/// water, waits until its pores are full, lifts it out, and lets it drip.
class Dip final : public StagedScene {
  public:
    explicit Dip(const SceneOptions& options);

    std::string status() const override;
    std::vector<Column> columns() const override;
    std::vector<double> row() const override;

  private:
    double barHeight() const;
    double depth() const;
    double meanSaturation() const;
    std::string doing() const;
    void script() override;
    void measure() override;
    void annotate(viewer::Picture& picture) const override;
    void showBar(viewer::Picture& picture) const;
    void check(std::vector<std::string>& list) const override;

    double waterLevel_;                // m
    double barHigh_;                   // m, of the bar at the start
    std::vector<int> held_;            // nodes in the clips
    std::vector<btVector3> fromBar_;   // of each of them, m
    double saturationUnderWater_ = 0;  // at the end of the rest under water
};

}  // namespace drench::demo
