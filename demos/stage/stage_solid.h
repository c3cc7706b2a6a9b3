// A solid on a stage, or an object that is only visible.
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
    // Surface kind for cloth; none: from Bullet's friction.
    std::optional<SurfaceKind> surface() const { return description_.surface; }
    // Null for an object that is only visible.
    btRigidBody* body() const { return body_; }

    // Its present state.
    SolidDescription describe() const;
    void show(viewer::Picture& picture) const;

  private:
    SolidDescription description_;
    btRigidBody* body_ = nullptr;
};

}  // namespace drench::demo
