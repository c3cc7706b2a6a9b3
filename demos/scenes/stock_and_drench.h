// The same hanging sheet with stock Bullet and with Drench.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "stage/scene.h"

namespace drench::demo {

/// A square metre of cloth, 64 x 64 nodes, hangs by its two upper corners: with stock Bullet and 10 iterations,
/// with Drench dry, and with Drench saturated. All have one substep of 1/60 s a frame.
class StockAndDrench final : public Scene {
  public:
    explicit StockAndDrench(const SceneOptions& options);
    ~StockAndDrench() override;
    StockAndDrench(const StockAndDrench&) = delete;
    StockAndDrench& operator=(const StockAndDrench&) = delete;

    void advance() override;
    bool finished() const override { return time_ >= duration_; }
    double progress() const override { return time_ / duration_; }
    std::string status() const override;
    viewer::Picture picture(View view) const override;
    std::vector<viewer::Picture> sideBySide() const override;
    std::string sideBySideName() const override { return "stock-and-drench"; }
    std::vector<Stage*> stages() override;
    std::optional<Table> result() const override;
    void report(std::ostream& out) const override;
    std::vector<std::string> failures() const override;

  private:
    class Specimen;

    double duration_ = 0;  // s
    double time_ = 0;      // s
    int frames_ = 0;
    std::array<std::unique_ptr<Specimen>, 3> specimens_;
};

}  // namespace drench::demo
