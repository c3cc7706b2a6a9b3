// A wet and a dry sheet on turning balls.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "../timed_scene.h"

namespace drench::demo {

/// Two sheets of the same cloth, 0.3 m square, lie on smooth balls of 0.3 m radius that turn about level axles: the
/// left sheet is dry, the right one saturated.
class Cling final : public TimedScene {
  public:
    explicit Cling(const SceneOptions& options);
    ~Cling() override;

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

    std::array<std::unique_ptr<Side>, 2> sides_;  // dry and wet
    double turned_ = 0;                           // rad, of the balls
    Table table_;                                 // each second, for the report
};

}  // namespace drench::demo
