// The one pre-tick slot of a Bullet world, shared between the application and any number of layers.
#pragma once

#include <BulletDynamics/Dynamics/btDynamicsWorld.h>

#include "drench/precision.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// Someone who wants to know that a substep of `dt` seconds begins.
class PreTickListener {
  public:
    virtual void preTick(btScalar dt) = 0;

  protected:
    ~PreTickListener() = default;
};

/// Calls `listener` at the start of each substep of `world`, after the application's own pre-tick callback,
/// if it has one, and after listeners that came earlier. The world's user info stays as it is.
void listenToPreTick(btDynamicsWorld& world, PreTickListener& listener);

/// Ends that, also from within a callback. The world is not touched, as it may be gone; should it still step,
/// its slot holds a callback that calls the application's own and nothing else.
void stopListeningToPreTick(btDynamicsWorld& world, PreTickListener& listener);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
