// A dry, a damp and a soaked sheet on slopes.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "../timed_scene.h"

namespace drench::demo {

/// Three sheets of the same cloth, 0.5 m square, lie on smooth slopes of 20 degrees side by side: from the left dry,
/// damp (pores 60 % full), and soaked, with so much water on the faces that it lubricates.
class Slide final : public TimedScene {
  public:
    explicit Slide(const SceneOptions& options);
    ~Slide() override;

    void advance() override;
    std::string status() const override;
    viewer::Picture picture() const override;
    std::optional<std::string> moment() const override;
    std::vector<SceneSheet> sheets() override;
    std::vector<Column> columns() const override;
    std::vector<double> row() const override;
    void report(std::ostream& out) const override;
    std::vector<std::string> failures() const override;

  private:
    class Lane;

    void checkLanes(std::vector<std::string>& list) const;
    double dryTheory(double time) const;

    std::array<std::unique_ptr<Lane>, 3> lanes_;  // dry, damp and soaked
    double measuredDry_ = 0;                      // m that the dry sheet slid until `measuredAt`
    Table table_;                                 // each quarter of a second, for the report
};

}  // namespace drench::demo
