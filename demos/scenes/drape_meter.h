// Cusick's drape test, dry and wet.
#pragma once

#include <string>
#include <vector>

#include "measure/silhouette.h"
#include "stage/staged_scene.h"

namespace drench::demo {

// Two discs of cloth, 30 cm across, lie clamped on pedestals of 18 cm, let go of their rims and come to rest: the
// left one dry, the right one saturated. Measured is what they then cover, seen from above: the drape
// coefficient, the share of the ring between pedestal and rim that is still covered, and the nodes, as the folds
// of a draped cloth are called.
class DrapeMeter final : public StagedScene {
  public:
    explicit DrapeMeter(const SceneOptions& options);

    bool finished() const override;
    std::string status() const override;
    std::optional<std::string> moment() const override;
    std::vector<Drawing> drawings() const override;
    std::optional<Table> result() const override;
    void report(std::ostream& out) const override;

    // What is measured of a disc.
    struct Drape {
        double coefficient;  // %
        int nodes;           // folds, counted
        int dominantOrder;   // of the largest wave in the silhouette's radius
        double nearest;      // m, least radius of the silhouette
        double farthest;     // m
    };
    Drape dry() const { return drape(0); }
    Drape wet() const { return drape(1); }

  private:
    void addDisc(const std::string& name, double fractionOfSaturation, const Fabric& fabric,
                 const SceneDescription& scene, int nodesAcross);
    void measure() override;
    std::string remarks() const override;
    void annotate(viewer::Picture& picture) const override;
    void check(std::vector<std::string>& list) const override;
    void checkTropical(std::vector<std::string>& list) const;

    Silhouette silhouette(std::size_t disc) const;
    Drape drape(std::size_t disc) const;
    bool atRest() const;

    bool isTropical_;
    std::vector<SceneCloth*> discs_;  // dry and wet
    int stillFor_ = 0;                // frames
};

}  // namespace drench::demo
