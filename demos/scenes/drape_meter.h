// Cusick's drape test, dry and wet.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "../silhouette.h"
#include "../timed_scene.h"

namespace drench::demo {

/// Two discs of cloth, 30 cm across, lie clamped on pedestals of 18 cm, let go of their rims and come to rest: the
/// left one dry, the right one saturated. Measured is what they then cover, seen from above: the drape
/// coefficient, the share of the ring between pedestal and rim that is still covered, and the nodes, as the folds
/// of a draped cloth are called.
class DrapeMeter final : public TimedScene {
  public:
    explicit DrapeMeter(const SceneOptions& options);
    ~DrapeMeter() override;

    void advance() override;
    bool finished() const override;
    std::string status() const override;
    viewer::Picture picture() const override;
    std::optional<std::string> moment() const override;
    std::vector<Drawing> drawings() const override;
    std::vector<SceneSheet> sheets() override;
    std::optional<Table> result() const override;
    void report(std::ostream& out) const override;
    std::vector<std::string> failures() const override;

    /// What is measured of a disc.
    struct Drape {
        double coefficient;  // %
        int nodes;           // folds, counted
        int dominantOrder;   // of the largest wave in the silhouette's radius
        double nearest;      // m, least radius of the silhouette
        double farthest;     // m
    };
    Drape dry() const;
    Drape wet() const;

  private:
    struct Disc;

    void addDisc(const std::string& name, double x, double shareOfSaturation, const SceneOptions& options);
    bool atRest() const;
    void checkTropical(std::vector<std::string>& list) const;

    bool isTropical_;
    std::vector<std::unique_ptr<Disc>> discs_;
    int stillFor_ = 0;  // frames
};

}  // namespace drench::demo
