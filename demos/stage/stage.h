// A place with sheets, solids, water and weather, which every scene is played on.
#pragma once

#include <drench/drench.h>

#include <memory>
#include <string>
#include <vector>

#include "description/scene_description.h"
#include "stage/pictures.h"
#include "stage/scene_cloth.h"
#include "stage/stage_effects.h"
#include "stage/stage_solid.h"
#include "stage/stage_source.h"
#include "stage/stage_weather.h"
#include "viewer/picture/picture.h"
#include "world/scene_world.h"

namespace drench::demo {

// Sheets, solids and sources in one world, in one weather. Made from a description, which it can give again at any
// time with everything as it is then. Small code of a scene's own may be played over it.
class Stage {
  public:
    // @throws std::invalid_argument for what cannot be built, naming it
    explicit Stage(const SceneDescription& description);
    ~Stage();
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    SceneWorld& world() { return *world_; }
    const SceneWorld& world() const { return *world_; }
    std::vector<SceneCloth*> sheets();
    std::vector<const SceneCloth*> sheets() const;
    // @throws std::invalid_argument for a name that is not there
    SceneCloth& sheet(const std::string& name);
    // Takes in a sheet of another shape than a rectangle, which must be in this world.
    SceneCloth& add(std::unique_ptr<SceneCloth> sheet);
    // The body of a solid. @throws std::invalid_argument for a name that is not there, or is only to look at
    btRigidBody& solid(const std::string& name);
    // What a source does; it may be changed at any time and counts from the next step on.
    // @throws std::invalid_argument for a name that is not there
    SourceDescription& source(const std::string& name);
    // Drops in the air; null where drops are not followed.
    const FallingDrops* drops() const { return drops_.get(); }

    // What the user may change at any time; it counts from the next step on.
    Weather& weather() { return weather_.now(); }
    const Weather& weather() const { return weather_.now(); }
    // How much faster water runs than the world's own time, for all sheets; 0 to 1e5.
    // @throws std::invalid_argument for a speed out of range
    void setWaterSpeed(double speed);
    // Shows what a nozzle sprays in the next step; it wets what is solid for the eye, and no sheet.
    void showSpray(const Nozzle& nozzle) { effects_.spray(nozzle); }
    // Whether anything may bring water; otherwise no vapour passes either.
    bool hasWater() const { return description_.water; }

    // Steps everything by one frame: weather, sources, world, drops, and what only the eye sees.
    void step(double frameTime);
    // That has passed, s, counted from the description's own.
    double time() const { return time_; }

    // The smallest step bound of all sheets, s.
    double stepBound() const;
    // Steps of the last frame: small ones, or substeps.
    int stepsOfFrame() const { return world_->stepsOfFrame(substeps_); }

    // Adds everything that there is to see, its sheets as in the view, and looks at it with the camera of the
    // description.
    void show(viewer::Picture& picture, View view) const;

    // The stage as it is now, with the pose and the water of each sheet. Drops in the air are left out.
    // @throws std::runtime_error for a sheet that is not a rectangle
    SceneDescription describe() const;

  private:
    void addSheets();
    void chooseSubsteps(double frameTime);

    SceneDescription description_;  // what was asked for; of sheets, solids, sources and weather see below
    std::unique_ptr<SceneWorld> world_;
    std::vector<StageSolid> solids_;
    std::vector<std::unique_ptr<SceneCloth>> sheets_;
    std::vector<StageSource> sources_;
    StageWeather weather_;
    std::unique_ptr<FallingDrops> drops_;
    StageEffects effects_;
    int substeps_ = 1;
    int frames_ = 0;
    double time_;  // s
};

}  // namespace drench::demo
