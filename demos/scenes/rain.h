// A sheet hangs half under a roof while it rains.
#pragma once

#include <string>
#include <vector>

#include "stage/staged_scene.h"

namespace drench::demo {

/// A sheet, 1.2 m square, hangs level between four posts, held at its corners and at the middle of two sides,
/// and sags like an awning. A roof covers the half of it at x < 0. First it comes to rest, then rain falls
/// for the rest of the time. The air is sealed off, so that all water in the sheltered half came out of the
/// rain.
class HalfUnderRoof final : public StagedScene {
  public:
    explicit HalfUnderRoof(const SceneOptions& options);

    std::string status() const override;
    std::vector<Column> columns() const override;
    std::vector<double> row() const override;

  private:
    void hang();
    double openGround() const;
    double rainTime() const;
    double saturationBetween(double from, double to) const;
    double shareDeepInShelter() const;
    double clear() const;
    double sag() const;
    double brought() const;
    void script() override;
    void annotate(viewer::Picture& picture) const override;
    std::vector<Column> reportColumns() const override;
    std::vector<double> reportRow() const override;
    std::string remarks() const override;
    void check(std::vector<std::string>& list) const override;

    double intensity_;         // mm/h, that it begins with
    double height_;            // m, at which the sheet is held
    double openAreaTime_ = 0;  // m2 s of open ground since the rain began
    double expected_ = 0;      // kg, on that ground by the intensity of the rain
};

}  // namespace drench::demo
