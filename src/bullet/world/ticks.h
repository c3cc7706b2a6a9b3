// The two moments of a Bullet world's substep at which a layer works, shared with the application's own tick
// callbacks.
#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <memory>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Someone who wants to know these moments.
class TickListener {
  public:
    // A substep of `dt` seconds begins.
    virtual void preTick(btScalar dt) = 0;
    // Contacts have been found, and none is solved yet.
    virtual void postTick(btScalar dt) = 0;

  protected:
    ~TickListener() = default;
};

// What a listener hears of a world, for as long as this lives. The application's callbacks are called first, its
// user info of the world stays as it is. Listeners may come and go, also within a callback, and the world may end
// before this: only a constructor and `awaitPostTick` touch it.
class Ticks {
  public:
    // Hears nothing yet. @param listener  outlives this
    Ticks(btDiscreteDynamicsWorld& world, TickListener& listener);
    ~Ticks();
    Ticks(const Ticks&) = delete;
    Ticks& operator=(const Ticks&) = delete;

    // Hears each pre-tick from now on, after listeners that came earlier. A callback that the application sets later
    // replaces Drench's, until the next listener comes. @pre the world exists
    void hearPreTicks();
    // Hears the next post-tick. The world's one slot is borrowed for that: as the callbacks run it holds the
    // application's again. @pre the world exists
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
