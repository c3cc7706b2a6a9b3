// A dry and a wet flag in the same wind.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "stage/staged_scene.h"

namespace drench::demo {

/// Two flags of the same cloth, 1.2 m x 0.8 m, on poles side by side: the left one dry, the right one saturated.
/// The wind blows from the left, steadily.
class Flag final : public StagedScene {
  public:
    explicit Flag(const SceneOptions& options);
    ~Flag() override;
    Flag(const Flag&) = delete;
    Flag& operator=(const Flag&) = delete;

    std::vector<Column> columns() const override;
    std::vector<double> row() const override;

  private:
    class Side;

    void measure() override;
    void annotate(viewer::Picture& picture) const override;
    std::string remarks() const override;
    void check(std::vector<std::string>& list) const override;

    std::array<std::unique_ptr<Side>, 2> sides_;  // dry and wet
};

}  // namespace drench::demo
