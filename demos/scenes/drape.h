// A wet and a dry sheet fall on a ball each.
#pragma once

#include <string>
#include <vector>

#include "stage/staged_scene.h"

namespace drench::demo {

/// Two sheets of the same cloth, 1.2 m square, fall from just above two balls of 0.3 m radius. The left one
/// is dry, the right one saturated.
class Drape final : public StagedScene {
  public:
    explicit Drape(const SceneOptions& options);

    std::string status() const override { return timeText(2); }
    std::vector<Column> columns() const override;
    std::vector<double> row() const override;

  private:
    double penetration(std::size_t side) const;
    double spread(std::size_t side) const;
    void annotate(viewer::Picture& picture) const override;
    void check(std::vector<std::string>& list) const override;

    std::vector<SolidDescription> balls_;  // of the dry and the wet sheet
};

}  // namespace drench::demo
