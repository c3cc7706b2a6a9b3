// The moment of a substep at which contacts have been found and none is solved yet: a Bullet world's post-tick.
#pragma once

#include <BulletDynamics/Dynamics/btDynamicsWorld.h>

#include "drench/precision.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// Someone who wants to know that moment.
class PostTickListener {
  public:
    virtual void postTick(btScalar dt) = 0;

  protected:
    ~PostTickListener() = default;
};

/// Calls `listener` once, at the next post-tick of `world`, after the application's own callback, if it has
/// one. The world's one post-tick slot is borrowed for that: as the callbacks run it holds the application's
/// again. The world's user info stays as it is.
void awaitPostTick(btDynamicsWorld& world, PostTickListener& listener);

/// Ends that, also from within a callback. The world is not touched, as it may be gone.
void stopAwaitingPostTick(btDynamicsWorld& world, PostTickListener& listener);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
