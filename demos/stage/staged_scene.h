// Base of scenes on one stage with a fixed duration.
#pragma once

#include <drench/drench.h>

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "stage/scene.h"
#include "stage/stage.h"

namespace drench::demo {

// A description with the options applied: fabric, resolution, duration, seed, solver and water.
// @throws std::invalid_argument for a resolution that differs from that of a saved state in the description
SceneDescription fitted(SceneDescription description, const SceneOptions& options);

// Runs a stage for a fixed duration. Derived scenes add motion, measurements and captions.
class StagedScene : public Scene {
  public:
    void advance() override;
    bool finished() const override { return time_ > duration_ - frameTime / 2; }
    double progress() const override;
    std::string status() const override { return timeText(1); }
    viewer::Picture picture(View view) const override;
    std::optional<std::string> moment() const override;
    std::vector<Stage*> stages() override { return {stage_.get()}; }
    void report(std::ostream& out) const override;
    std::vector<std::string> failures() const override;

  protected:
    // Number of frames between rows of the report, and between recorded moments; 0: none.
    struct Pace {
        int rows;
        int moments;
    };

    // @param description  with the options applied
    StagedScene(const SceneDescription& description, const Pace& pace);

    // Actions of the scene before each frame, and measurements after it.
    virtual void script() {}
    virtual void measure() {}
    // Adds objects that are not on the stage, and the caption, to the picture.
    virtual void annotate(viewer::Picture&) const {}
    // Columns and rows of the report; by default those of the log, after the time.
    virtual std::vector<Column> reportColumns() const;
    virtual std::vector<double> reportRow() const;
    // Text of the report below its rows.
    virtual std::string remarks() const { return {}; }
    // Adds failed checks of the result, except those of the ledgers.
    virtual void check(std::vector<std::string>&) const {}

    Stage& stage() { return *stage_; }
    const Stage& stage() const { return *stage_; }
    // The sheet at that index of the description.
    SceneCloth& cloth(std::size_t index = 0) const { return *cloths_[index]; }
    double time() const { return time_; }  // s
    int frames() const { return frames_; }
    double duration() const { return duration_; }  // s

    // Whether this frame is the last, or its number a multiple of `framesBetween`.
    bool isDue(int framesBetween) const { return frames_ % framesBetween == 0 || finished(); }
    // "1.5 s of 30.0 s"
    std::string timeText(int digits) const;
    // "rain-01500ms"
    std::string momentName() const;

  private:
    std::string name_;
    Pace pace_;
    double duration_;  // s
    std::unique_ptr<Stage> stage_;
    std::vector<SceneCloth*> cloths_;
    int frames_ = 0;
    double time_ = 0;  // since the start, s
    Table table_;      // for the report
};

// Water that a source has added to a cloth, by the name of its account, kg.
double broughtBy(const std::string& account, const WetCloth& cloth);

// Adds a failed check if water was created or lost.
void checkLedger(std::vector<std::string>& list, const SceneCloth& cloth);

}  // namespace drench::demo
