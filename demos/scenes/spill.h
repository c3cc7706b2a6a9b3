// Water poured on the middle of a tablecloth spreads.
#pragma once

#include <string>
#include <vector>

#include "stage/staged_scene.h"

namespace drench::demo {

/// A cloth, 1.1 m square, lies on a table and hangs over its edges. A jug pours water on its middle; the
/// stain spreads in the cloth by wicking, twenty times as fast as in life. The air is sealed off, so that the
/// stain neither dries nor grows by vapour.
class Spill final : public StagedScene {
  public:
    explicit Spill(const SceneOptions& options);

    std::string status() const override;
    std::optional<std::string> moment() const override;
    std::vector<Column> columns() const override;
    std::vector<double> row() const override;

  private:
    /// The part of the cloth that is visibly wet.
    struct Stain {
        double area = 0;            // m2
        double extentWarp = 0;      // m, root mean square distance from its middle along the warp, doubled
        double extentWeft = 0;      // m, the same along the weft
        double meanSaturation = 0;  // 0 to 1

        double radius() const;
        double roundness() const;
    };

    void script() override;
    void measure() override;
    void annotate(viewer::Picture& picture) const override;
    std::vector<Column> reportColumns() const override;
    std::vector<double> reportRow() const override;
    std::string remarks() const override;
    void check(std::vector<std::string>& list) const override;

    double pourNow();
    Stain stain() const;
    double poured() const { return broughtBy("spray", cloth().wet()); }  // kg
    double deepestInTable() const;
    double waterTime(double seconds) const { return seconds * cloth().waterSpeed(); }
    void showJug(viewer::Picture& picture) const;
    void showStream(viewer::Picture& picture) const;

    SolidDescription table_;
    Eigen::Vector3d spout_;
    double pouringRate_ = 0;       // kg/s of water time, now
    double emptyAt_ = 0;           // s, when the last of the water left the jug; 0 before
    double largestStain_ = 0;      // m2, since then
    double largestShrinkage_ = 0;  // share of the largest stain before that a later one lacked
};

}  // namespace drench::demo
