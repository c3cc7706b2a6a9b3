// A wet and a dry sheet fall on a ball each.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "../timed_scene.h"

namespace drench::demo {

/// Two sheets of the same cloth, 1.2 m square, fall from just above two balls of 0.3 m radius. The left one
/// is dry, the right one saturated.
class Drape final : public TimedScene {
  public:
    explicit Drape(const SceneOptions& options);
    ~Drape() override;

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
    struct Side;

    double stepBound() const;
    void addSide(const std::string& name, double x, double shareOfSaturation, int nodes);

    std::vector<std::unique_ptr<Side>> sides_;
    Table table_;  // each tenth of a second, for the report
};

}  // namespace drench::demo
