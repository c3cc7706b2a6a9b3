// The wetting experiment: a hanging sheet, dry and then with ten amounts of water up to saturation.
#pragma once

#include <memory>

#include "stage/scene.h"
#include "stage/stage.h"

namespace drench::demo {

// A sheet of 55 x 45 nodes hangs by its two upper corners over a ball and the ground. Step 0 is dry; steps n
// = 1..10 have 0.010 + 0.083 n grams of water per inner node of cotton, up to saturation; other fabrics get
// the same fractions of their own saturation. The water is fixed in the pores. Each step starts from a flat
// sheet at rest, settles in still air, is measured, then exposed to wind, measured again, and swings freely.
class TenSteps final : public Scene {
  public:
    explicit TenSteps(const SceneOptions& options);
    ~TenSteps() override;
    TenSteps(const TenSteps&) = delete;
    TenSteps& operator=(const TenSteps&) = delete;

    void advance() override;
    bool finished() const override;
    double progress() const override;
    std::string status() const override;
    viewer::Picture picture(View view) const override;
    std::optional<std::string> moment() const override;
    void noteDrawTime(double seconds) override;
    std::vector<Stage*> stages() override { return {stage_.get()}; }
    std::vector<Column> columns() const override { return {{"step", 0}}; }
    std::vector<double> row() const override { return {double(results_.size() - 1)}; }
    std::optional<Table> result() const override { return table(); }
    Table table() const;
    void report(std::ostream& out) const override;
    std::vector<std::string> failures() const override;

    // Results of a step; NaN if not measured yet.
    struct Result {
        double waterPerNode;    // g, of an inner node
        double sheetMass;       // kg
        double massRatio;       // ratio to the dry sheet
        double sag;             // m, of the upper edge's middle below the line between the corners, still air
        double meanStrain;      // of stretch and shear links, still air
        double windDeflection;  // degrees, angle of the line from the upper edge to the centre of mass
        double swingPeriod;     // s, after the wind has stopped
        double albedo;          // mean of the three channels and all nodes
        double simulationRate;  // frames of 1/60 s simulated per second of computing
        double frameRate;       // the same including rendering
        int steps;              // per frame: small steps, or substeps
        double imbalance;       // of the ledger, relative to what was supplied
    };

  private:
    class Swing;

    enum class Phase { settling, blowing, swinging };

    SceneCloth& sheet() const { return *sheet_; }
    double mass() const;
    double sag() const;
    btVector3 centreOfMass() const;
    double deflection() const;
    double meanAlbedo() const;
    double waterOfInnerNode() const;
    void showLine(viewer::Picture& picture) const;

    void beginStep(int step);
    void beginPhase(Phase phase);
    void measureStill();
    void measureWind();
    void measureSwing();
    void endStep();

    SceneOptions options_;
    double windSpeed_;  // m/s, wind of the next step
    std::unique_ptr<Stage> stage_;
    SceneCloth* sheet_ = nullptr;
    std::unique_ptr<Swing> swing_;
    std::vector<Result> results_;  // the last one belongs to the current step
    Phase phase_ = Phase::settling;
    double phaseTime_ = 0;         // s since the phase began
    std::vector<double> samples_;  // sag or deflection over the end of the phase
    std::vector<double> strains_;  // mean strain over the same
    double totalTime_ = 0;         // s simulated since the experiment began
    double computing_ = 0;         // s of computing in this step
    int frames_ = 0;               // simulated in this step
    double drawing_ = 0;           // s, for the last picture; NaN before
    bool momentNow_ = false;
    bool done_ = false;
};

}  // namespace drench::demo
