// A sheet is dipped into a tank of water and lifted out.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "../scene_cloth.h"
#include "../timed_scene.h"
#include "../water_effects.h"

namespace drench::demo {

/// A sheet, 0.6 m x 0.5 m, hangs from a bar by two clips. The bar lowers it into a tank until all of it is under
/// water, waits until its pores are full, lifts it out, and lets it drip.
class Dip final : public TimedScene {
  public:
    explicit Dip(const SceneOptions& options);
    ~Dip() override;

    void advance() override;
    std::string status() const override;
    viewer::Picture picture() const override;
    std::optional<std::string> moment() const override;
    std::vector<SceneSheet> sheets() override { return {{"sheet", &cloth_->wet()}}; }
    std::vector<Column> columns() const override;
    std::vector<double> row() const override;
    void report(std::ostream& out) const override;
    std::vector<std::string> failures() const override;

  private:
    double barHeight() const;
    void moveBar();
    double depth() const;
    double meanSaturation() const;
    std::string doing() const;
    void showTank(viewer::Picture& picture) const;
    void showBar(viewer::Picture& picture) const;

    std::unique_ptr<SceneCloth> cloth_;
    std::unique_ptr<FallingDrops> drops_;
    std::unique_ptr<WaterEffects> effects_;
    std::vector<int> held_;            // nodes in the clips
    std::vector<btVector3> fromBar_;   // of each of them, m
    double saturationUnderWater_ = 0;  // at the end of the rest under water
    Table table_;                      // each second, for the report
};

}  // namespace drench::demo
