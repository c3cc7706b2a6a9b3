// A wet and a dry sheet on turning balls.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "stage/staged_scene.h"

namespace drench::demo {

/// Two sheets of the same cloth, 0.3 m square, lie on smooth balls of 0.3 m radius that turn about level axles: the
/// left sheet is dry, the right one saturated.
class Cling final : public StagedScene {
  public:
    explicit Cling(const SceneOptions& options);
    ~Cling() override;
    Cling(const Cling&) = delete;
    Cling& operator=(const Cling&) = delete;

    std::vector<Column> columns() const override;
    std::vector<double> row() const override;

  private:
    class Side;

    double turnRateNow() const;
    void script() override;
    void measure() override;
    void annotate(viewer::Picture& picture) const override;
    std::string remarks() const override;
    void check(std::vector<std::string>& list) const override;

    std::array<std::unique_ptr<Side>, 2> sides_;  // dry and wet
    double turned_ = 0;                           // rad, of the balls
};

}  // namespace drench::demo
