// A strip with its foot in water: how high the water climbs in which time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stage/staged_scene.h"

namespace drench::demo {

/// A vertical strip, 3 cm wide and 30 cm long, warp upwards, both long edges held in a frame, its foot 1 cm in a
/// dish of water. The water runs 60 times as fast as the clock: 30 minutes take 30 seconds. No vapour passes, so
/// that nothing but height holds the water back.
class Wick final : public StagedScene {
  public:
    explicit Wick(const SceneOptions& options);

    std::string status() const override;
    std::optional<std::string> moment() const override;
    std::vector<Column> columns() const override { return {{"front_height_m", 4}}; }
    std::vector<double> row() const override { return {frontHeight()}; }
    void report(std::ostream& out) const override;

  private:
    /// The law of Washburn, height^2 = coefficient (time - offset), fitted to the early rise.
    struct Fit {
        double coefficient;    // m2/s
        double determination;  // R2, 1
    };

    explicit Wick(const SceneDescription& description);

    void measure() override;
    void annotate(viewer::Picture& picture) const override;
    void check(std::vector<std::string>& list) const override;

    /// Highest place that is at least a tenth saturated, m above the water.
    double frontHeight() const;
    double rowSaturation(int row) const;
    double heightAfter(double minutes) const;
    std::optional<Fit> fit() const;
    double waterMinutes() const;
    bool hasReference() const;
    void reportFit(std::ostream& out) const;

    double spacing_;               // m, along the warp
    double level_;                 // m, of the water
    std::vector<double> heights_;  // m, of the front after each frame
};

}  // namespace drench::demo
