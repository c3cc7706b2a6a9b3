// Water of a stage in pictures.
#pragma once

#include <memory>
#include <vector>

#include "description/scene_description.h"
#include "effects/water_effects.h"
#include "stage/scene_cloth.h"
#include "stage/stage_source.h"
#include "stage/stage_weather.h"

namespace drench::demo {

// Follows rain, sprays, pools and drops; reads the stage and does not change it. Costs no time until there is
// water in the air.
class StageEffects {
  public:
    StageEffects(const btCollisionWorld& world, const SceneDescription& description);

    // Shows the spray of a nozzle in the next frame.
    void spray(const Nozzle& nozzle) { nozzles_.push_back(nozzle); }

    // Follows a frame that has just been simulated.
    // @param drops  null if drops are not simulated
    void step(double frameTime, double time, const Weather& weather, const std::vector<StageSource>& sources,
              const std::vector<std::unique_ptr<SceneCloth>>& sheets, const FallingDrops* drops);
    void show(viewer::Picture& picture) const;

  private:
    void cloudOver(double rain, double frameTime);
    void setPools(const std::vector<StageSource>& sources);

    const btCollisionWorld& world_;
    WaterEffectsLimits limits_;
    Eigen::AlignedBox3d shower_;   // region in which rain is visible
    std::vector<Nozzle> nozzles_;  // of the next frame
    std::unique_ptr<WaterEffects> effects_;
    double sunshine_;  // see viewer::Picture
};

}  // namespace drench::demo
