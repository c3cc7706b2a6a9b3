// A scene that runs for a set time; what such scenes share.
#pragma once

#include <drench/drench.h>

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "scene.h"

namespace drench::demo {

/// Sheets of one fabric in one world, which runs until a set time is over.
class TimedScene : public Scene {
  public:
    bool finished() const override { return time_ >= duration_; }
    double progress() const override;
    double& windSpeed() override { return windSpeed_; }

  protected:
    /// @param ownDuration in seconds, where the options ask for none
    /// @param steps  of a SmallStepSolver
    TimedScene(const SceneOptions& options, double ownDuration, const SmallSteps& steps = {});

    /// Chooses as many substeps as a sheet with this step bound needs, s; where fewer only make links softer,
    /// not more than `most`.
    void chooseSubsteps(double stepBound, int most);
    /// Slows a sheet down by a rate, 1/s. Stock Bullet damps per substep, so choose these first.
    void damp(btSoftBody& sheet, double rate) const;
    /// Steps the world, and with it the clock, by one frame.
    void stepWorld();

    /// Whether this frame is one of each so many, or the last.
    bool isDue(int framesBetween) const { return frames_ % framesBetween == 0 || finished(); }
    /// "1.5 s of 30.0 s"
    std::string timeText(int digits) const;
    /// "rain-01500ms"
    std::string momentName(const std::string& scene) const;
    /// How frames are divided, and the longest substep that a sheet stands, s, where that counts.
    void reportSteps(std::ostream& out, double stepBound) const;

    Fabric fabric_;
    double duration_;       // s
    double windSpeed_ = 0;  // m/s
    std::unique_ptr<SceneWorld> bullet_;
    int substeps_ = 1;  // of a frame
    int frames_ = 0;
    double time_ = 0;  // s
};

/// What a source has brought to a cloth, kg.
double broughtBy(const Source& source, const WetCloth& cloth);

/// Adds to the list if water was made or lost.
void checkLedger(std::vector<std::string>& list, const WetCloth& cloth,
                 const std::string& name = "the ledger");

}  // namespace drench::demo
