// Laundry on a line: it drips, and then dries in the wind.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "stage/staged_scene.h"

namespace drench::demo {

/// A soaked sheet, 1.0 m x 0.8 m, is pegged to a line in air of 25 degrees and 50 % humidity. The wind turns to and
/// fro, so that the sheet moves, but its speed stays the same. The water runs 240 times as fast as the clock: an hour
/// takes 15 seconds. Ends when every node is in balance with the air, or after 90 seconds.
class Clothesline final : public StagedScene {
  public:
    explicit Clothesline(const SceneOptions& options);

    bool finished() const override { return dry_ || StagedScene::finished(); }
    double progress() const override;
    std::string status() const override;
    std::optional<std::string> moment() const override { return momentNow_; }
    std::vector<Column> columns() const override { return {{"mass_kg", 5}, {"content", 4}}; }
    std::vector<double> row() const override { return {cloth().mass(), content()}; }
    void report(std::ostream& out) const override;

  private:
    /// What there was after a frame.
    struct Sample {
        double mass;        // kg, cloth and water
        double film;        // kg
        double pores;       // kg
        double dripped;     // kg
        double evaporated;  // kg
        double caught;      // kg, from drops that fell on the sheet again
        double couldDry;    // kg, that a sheet wet all over would have lost by now
        double dryNodes;    // share of the nodes whose fibres are no longer full of water
    };
    /// Drying while the sheet is wet all over, g/(m2 h).
    struct ConstantRate {
        double measured;
        double expected;
        double from, to;  // mean content, kg/kg
    };
    void script() override;
    void measure() override;
    void annotate(viewer::Picture& picture) const override;
    void check(std::vector<std::string>& list) const override;

    void hang();
    double rippleDepth(double column) const;
    void noteDrops();
    void note();
    void noteMoment();
    double content() const { return cloth().wet().waterMass() / cloth().wet().dryMass(); }
    double area() const;
    double waterMinutes(double time) const;
    bool inBalance() const;
    double shareOfDryNodes() const;
    double contentOf(const Sample& sample) const;
    std::optional<ConstantRate> constantRate() const;
    void showPegs(viewer::Picture& picture) const;
    void checkDrops(std::vector<std::string>& list) const;
    void checkDrying(std::vector<std::string>& list) const;

    bool wholeLength_;       // nobody asked for it to end early
    double balance_;         // content in balance with the air, kg/kg
    std::vector<int> pegs_;  // columns in which they sit
    int mostSteps_ = 0;
    bool dry_ = false;
    std::vector<Sample> samples_;
    double lightestDrop_;  // kg
    double heaviestDrop_;  // kg
    std::int64_t dropsFallen_ = 0;
    std::size_t momentsPassed_ = 0;
    std::optional<std::string> momentNow_;
};

}  // namespace drench::demo
