// A scene that consists only of its description.
#pragma once

#include <string>
#include <vector>

#include "stage/staged_scene.h"

namespace drench::demo {

// Runs a description for its duration; it reports the water of each sheet, and checks the water balance.
class DescribedScene final : public StagedScene {
  public:
    DescribedScene(const SceneDescription& description, const SceneOptions& options)
        : StagedScene(fitted(description, options), {60, 120}), title_(description.text) {}

  private:
    void annotate(viewer::Picture& picture) const override;
    std::vector<Column> reportColumns() const override;
    std::vector<double> reportRow() const override;

    std::string title_;
};

}  // namespace drench::demo
