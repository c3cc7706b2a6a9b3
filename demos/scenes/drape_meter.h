// Cusick's drape test, dry and wet.
#pragma once

#include <string>
#include <vector>

#include "measure/silhouette.h"
#include "stage/staged_scene.h"

namespace drench::demo {

// Two discs of cloth, 30 cm in diameter, lie clamped on pedestals of 18 cm, are released and come to rest:
// the left one dry, the right one saturated. The result is their silhouette from above: the drape
// coefficient, which is the fraction of the ring between pedestal and rim that is still covered, and the
// number of folds, which are called nodes in drape tests.
class DrapeMeter final : public StagedScene {
  public:
    explicit DrapeMeter(const SceneOptions& options);

    bool finished() const override;
    std::string status() const override;
    std::optional<std::string> moment() const override;
    std::vector<Drawing> drawings() const override;
    std::optional<Table> result() const override;
    void report(std::ostream& out) const override;

    // Results for a disc.
    struct Drape {
        double coefficient;  // %
        int nodes;           // number of folds
        int dominantOrder;   // dominant number of waves of the silhouette's radius
        double nearest;      // m, smallest radius of the silhouette
        double farthest;     // m, largest radius of the silhouette
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
