// Water poured on the middle of a tablecloth spreads.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "../timed_scene.h"

namespace drench::demo {

/// A cloth, 1.1 m square, lies on a table and hangs over its edges. A jug pours water on its middle; the
/// stain spreads in the cloth by wicking, twenty times as fast as in life. The air is sealed off, so that the
/// stain neither dries nor grows by vapour.
class Spill final : public TimedScene {
  public:
    explicit Spill(const SceneOptions& options);
    ~Spill() override;

    void advance() override;
    std::string status() const override;
    viewer::Picture picture() const override;
    std::optional<std::string> moment() const override;
    std::vector<SceneSheet> sheets() override { return {{"tablecloth", cloth_.get()}}; }
    std::vector<Column> columns() const override;
    std::vector<double> row() const override;
    void report(std::ostream& out) const override;
    std::vector<std::string> failures() const override;

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

    void addTable();
    void addCloth(const SceneOptions& options);
    void pour();
    Stain stain() const;
    double poured() const { return broughtBy(*jug_, *cloth_); }  // kg
    double deepestInTable() const;
    std::vector<double> reportRow() const;
    void showTable(viewer::Picture& picture) const;
    void showJug(viewer::Picture& picture) const;

    btRigidBody* table_ = nullptr;
    std::unique_ptr<btSoftBody> sheet_;
    std::unique_ptr<WetCloth> cloth_;
    Spray* jug_ = nullptr;
    double emptyAt_ = 0;           // s, when the last of the water left the jug; 0 before
    double largestStain_ = 0;      // m2, since then
    double largestShrinkage_ = 0;  // share of the largest stain before that a later one lacked
    Table rows_;                   // every two seconds, for the report
};

}  // namespace drench::demo
