// Sheets, solids, water and weather in one world; the base of every scene.
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

// Sheets, solids and sources in one world and one weather. It is made from a description, and can return a
// description of its present state at any time. A scene may add code of its own.
class Stage {
  public:
    // @throws std::invalid_argument that names what cannot be made
    explicit Stage(const SceneDescription& description);
    ~Stage();
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    SceneWorld& world() { return *world_; }
    const SceneWorld& world() const { return *world_; }
    std::vector<SceneCloth*> sheets();
    std::vector<const SceneCloth*> sheets() const;
    // @throws std::invalid_argument for an unknown name
    SceneCloth& sheet(const std::string& name);
    // Adds a sheet that is not a rectangle; it must be in this world.
    SceneCloth& add(std::unique_ptr<SceneCloth> sheet);
    // The body of a solid. @throws std::invalid_argument for an unknown name, or an object that is only
    // visible
    btRigidBody& solid(const std::string& name);
    // Settings of a source; they may be changed at any time and take effect in the next step.
    // @throws std::invalid_argument for an unknown name
    SourceDescription& source(const std::string& name);
    // Drops in the air; null if drops are not simulated.
    const FallingDrops* drops() const { return drops_.get(); }

    // Settings that may be changed at any time; they take effect in the next step.
    Weather& weather() { return weather_.now(); }
    const Weather& weather() const { return weather_.now(); }
    // Ratio of water time to simulated time, for all sheets; 0 to 1e5.
    // @throws std::invalid_argument for a speed out of range
    void setWaterSpeed(double speed);
    // Shows the spray of a nozzle in the next step; in pictures it wets solids, but it wets no sheet.
    void showSpray(const Nozzle& nozzle) { effects_.spray(nozzle); }
    // Whether sources may add water; otherwise there is no vapour exchange either.
    bool hasWater() const { return description_.water; }

    // Advances everything by one frame: weather, sources, world, drops, and effects for pictures.
    void step(double frameTime);
    // Simulated time, s, including the `time` of the description.
    double time() const { return time_; }

    // The smallest step bound of all sheets, s.
    double stepBound() const;
    // Steps of the last frame: small steps, or substeps.
    int stepsOfFrame() const { return world_->stepsOfFrame(substeps_); }

    // Adds everything visible to a picture, with sheets in the given view, and sets the camera of the
    // description.
    void show(viewer::Picture& picture, View view) const;

    // A description of the present state, with positions and water of each sheet; drops in the air are
    // omitted.
    // @throws std::runtime_error for a sheet that is not a rectangle
    SceneDescription describe() const;

  private:
    void addSheets();
    void chooseSubsteps(double frameTime);

    SceneDescription description_;  // as given; sheets, solids, sources and weather are below
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
