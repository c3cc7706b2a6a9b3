#include "bullet/world/post_tick.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <vector>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

/// Bullet sets the callback but has no way to ask for it; a derived class may look.
struct PostTickSlot : btDynamicsWorld {
    static btInternalTickCallback of(btDynamicsWorld& world) {
        return world.*(&PostTickSlot::m_internalTickCallback);
    }
};

void fillPostTickSlot(btDynamicsWorld& world, btInternalTickCallback callback) {
    constexpr bool isPreTick = false;
    world.setInternalTickCallback(callback, world.getWorldUserInfo(), isPreTick);
}

/// What waits for a world's post-tick.
struct Waiting {
    btInternalTickCallback applicationCallback = nullptr;
    std::vector<PostTickListener*> listeners;  // none in place of those that have ended
};

/// The only way from the world that a callback is told to its listeners; see pre_tick.cpp. An entry stays for
/// as long as the program.
class WaitingTable {
  public:
    static WaitingTable& instance() {
        static WaitingTable& table = *new WaitingTable;
        return table;
    }

    Waiting& waitingFor(btDynamicsWorld& world) {
        const std::lock_guard<std::mutex> lock(mutex_);
        return waiting_[&world];
    }

  private:
    std::mutex mutex_;  // worlds may step in different threads
    std::map<btDynamicsWorld*, Waiting> waiting_;
};

void callAll(btDynamicsWorld* world, btScalar dt) {
    Waiting& waiting = WaitingTable::instance().waitingFor(*world);
    const btInternalTickCallback callback = waiting.applicationCallback;
    fillPostTickSlot(*world, callback);
    if (callback) callback(world, dt);
    for (std::size_t i = 0; i < waiting.listeners.size(); ++i)
        if (waiting.listeners[i]) waiting.listeners[i]->postTick(dt);
    waiting.listeners.clear();
}

}  // namespace

void awaitPostTick(btDynamicsWorld& world, PostTickListener& listener) {
    Waiting& waiting = WaitingTable::instance().waitingFor(world);
    const btInternalTickCallback current = PostTickSlot::of(world);
    if (current != callAll) {
        waiting.applicationCallback = current;
        fillPostTickSlot(world, callAll);
    }
    std::vector<PostTickListener*>& listeners = waiting.listeners;
    // It waits already where the substep before was left undone.
    if (std::find(listeners.begin(), listeners.end(), &listener) == listeners.end())
        listeners.push_back(&listener);
}

void stopAwaitingPostTick(btDynamicsWorld& world, PostTickListener& listener) {
    std::vector<PostTickListener*>& listeners = WaitingTable::instance().waitingFor(world).listeners;
    std::replace(listeners.begin(), listeners.end(), &listener, static_cast<PostTickListener*>(nullptr));
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
