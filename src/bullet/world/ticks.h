// The two points of a Bullet world's substep at which a layer works. They are shared with the application's
// own tick callbacks.
#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <memory>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Interface for classes that are notified at these points.
class TickListener {
  public:
    // Called at the start of a substep of `dt` seconds.
    virtual void preTick(btScalar dt) = 0;
    // Called when contacts have been found, but none has been solved yet.
    virtual void postTick(btScalar dt) = 0;

  protected:
    ~TickListener() = default;
};

// Notifies a listener of the substeps of a world, until destroyed. The application's callbacks are called
// first, and its user info of the world is not changed. Listeners may be added and removed at any time, also
// within a callback. The world may be destroyed before this: only the constructor, `hearPreTicks` and
// `awaitPostTick` access it.
class Ticks {
  public:
    // Not notified yet. @param listener  must outlive this
    Ticks(btDiscreteDynamicsWorld& world, TickListener& listener);
    ~Ticks();
    Ticks(const Ticks&) = delete;
    Ticks& operator=(const Ticks&) = delete;

    // Notifies of each pre-tick from now on, after listeners that were added earlier. A callback that the
    // application sets later replaces Drench's, until the next listener is added. @pre the world exists
    void hearPreTicks();
    // Notifies of the next post-tick. For that our callback is put into the world's only slot; before
    // callbacks are called, the application's own is restored there. @pre the world exists
    void awaitPostTick();

  private:
    struct Chain;
    class Table;
    static void runPreTick(btDynamicsWorld* world, btScalar dt);
    static void runPostTick(btDynamicsWorld* world, btScalar dt);

    btDiscreteDynamicsWorld& world_;
    TickListener& listener_;
    std::shared_ptr<Chain> chain_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
