// A strip with its foot in water: how high the water climbs in which time.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "../timed_scene.h"

namespace drench::demo {

/// A vertical strip, 3 cm wide and 30 cm long, warp upwards, both long edges held in a frame, its foot 1 cm in a
/// dish of water. The water runs 60 times as fast as the clock: 30 minutes take 30 seconds. No vapour passes, so
/// that nothing but height holds the water back.
class Wick final : public TimedScene {
  public:
    explicit Wick(const SceneOptions& options);
    ~Wick() override;

    void advance() override;
    bool finished() const override { return time_ > duration_ - frameTime / 2; }
    std::string status() const override;
    viewer::Picture picture() const override;
    std::optional<std::string> moment() const override;
    std::vector<SceneSheet> sheets() override { return {{"strip", cloth_.get()}}; }
    std::vector<Column> columns() const override { return {{"front_height_m", 4}}; }
    std::vector<double> row() const override { return {frontHeight()}; }
    void report(std::ostream& out) const override;
    std::vector<std::string> failures() const override;

  private:
    /// The law of Washburn, height^2 = coefficient (time - offset), fitted to the early rise.
    struct Fit {
        double coefficient;    // m2/s
        double determination;  // R2, 1
    };

    /// Highest place that is at least a tenth saturated, m above the water.
    double frontHeight() const;
    double rowSaturation(int row) const;
    double heightAfter(double minutes) const;
    std::optional<Fit> fit() const;
    double waterMinutes() const;
    bool hasReference() const;
    void reportFit(std::ostream& out) const;

    bool isCotton_;
    int nodesWarp_;
    int nodesWeft_;
    double spacing_;  // m, along the warp
    double depth_;    // m, of the foot below the water
    std::unique_ptr<btSoftBody> sheet_;
    std::unique_ptr<WetCloth> cloth_;
    std::vector<double> heights_;  // m, of the front after each frame
};

}  // namespace drench::demo
