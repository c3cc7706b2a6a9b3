// A dry and a wet flag in the same wind.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "../timed_scene.h"

namespace drench::demo {

/// Two flags of the same cloth, 1.2 m x 0.8 m, on poles side by side: the left one dry, the right one saturated.
/// The wind blows from the left, steadily.
class Flag final : public TimedScene {
  public:
    explicit Flag(const SceneOptions& options);
    ~Flag() override;

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
    class Side;

    /// The wind suits a cotton flag, so only that one is checked for how fast it flaps.
    bool isCotton_;
    std::array<std::unique_ptr<Side>, 2> sides_;  // dry and wet
    Table table_;                                 // each second, for the report
};

}  // namespace drench::demo
