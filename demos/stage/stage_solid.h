// Something solid on a stage, or something that is only to look at.
#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "description/scene_description.h"
#include "viewer/picture/picture.h"
#include "world/scene_world.h"

namespace drench::demo {

// A solid as described, in a world that owns its body.
class StageSolid {
  public:
    StageSolid(SceneWorld& world, const SolidDescription& description);

    const std::string& name() const { return description_.name; }
    // How cloth takes to it; none: as Bullet's friction says.
    std::optional<SurfaceKind> surface() const { return description_.surface; }
    // None where it is only to look at.
    btRigidBody* body() const { return body_; }

    // As it is now.
    SolidDescription describe() const;
    void show(viewer::Picture& picture) const;

  private:
    SolidDescription description_;
    btRigidBody* body_ = nullptr;
};

}  // namespace drench::demo
