// A scene that is played on one stage for a set time; what such scenes share.
#pragma once

#include <drench/drench.h>

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "stage/scene.h"
#include "stage/stage.h"

namespace drench::demo {

// A description as the options want it: with their fabric, resolution, end, seed, solver and water.
// @throws std::invalid_argument for a resolution other than that of a state that is part of the description
SceneDescription fitted(SceneDescription description, const SceneOptions& options);

// A stage that runs until a set time is over. Scenes add what they script, measure and say.
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
    // How often it notes a row for the report and has a moment worth keeping, frames; 0: never.
    struct Pace {
        int rows;
        int moments;
    };

    // @param description  as fitted to the options
    StagedScene(const SceneDescription& description, const Pace& pace);

    // What the scene does before each frame, and what it measures after it.
    virtual void script() {}
    virtual void measure() {}
    // Adds to the picture what is not on the stage, and its caption.
    virtual void annotate(viewer::Picture&) const {}
    // Columns and rows of the report; by default those of the log, after the time.
    virtual std::vector<Column> reportColumns() const;
    virtual std::vector<double> reportRow() const;
    // What the report says below its rows.
    virtual std::string remarks() const { return {}; }
    // Adds what is wrong with the result, but for the ledgers of the sheets.
    virtual void check(std::vector<std::string>&) const {}

    Stage& stage() { return *stage_; }
    const Stage& stage() const { return *stage_; }
    // The sheet of that place in the description.
    SceneCloth& cloth(std::size_t index = 0) const { return *cloths_[index]; }
    double time() const { return time_; }  // s
    int frames() const { return frames_; }
    double duration() const { return duration_; }  // s

    // Whether this frame is one of each so many, or the last.
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
    double time_ = 0;  // s since it began
    Table table_;      // for the report
};

// What a source has brought to a cloth, by the name of its account, kg.
double broughtBy(const std::string& account, const WetCloth& cloth);

// Adds to the list if water was made or lost.
void checkLedger(std::vector<std::string>& list, const SceneCloth& cloth);

}  // namespace drench::demo
