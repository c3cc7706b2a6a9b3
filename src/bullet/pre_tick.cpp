#include "pre_tick.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <vector>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

/// Bullet sets the pre-tick callback but has no way to ask for it; a derived class may look.
struct PreTickSlot : btDynamicsWorld {
    static btInternalTickCallback of(btDynamicsWorld& world) {
        return world.*(&PreTickSlot::m_internalPreTickCallback);
    }
};

void fillSlot(btDynamicsWorld& world, btInternalTickCallback callback) {
    constexpr bool isPreTick = true;
    world.setInternalTickCallback(callback, world.getWorldUserInfo(), isPreTick);
}

struct Chain {
    btInternalTickCallback applicationCallback = nullptr;
    std::vector<PreTickListener*> listeners;
};

/// A tick callback is told its world and nothing else, and the world's user info belongs to the application:
/// this table is the only way from one to the other. It holds no settings and no state of a simulation.
class ChainTable {
  public:
    static ChainTable& instance() {
        static ChainTable table;
        return table;
    }

    Chain& chainOf(btDynamicsWorld& world) {
        const std::lock_guard<std::mutex> lock(mutex_);
        return chains_[&world];  // a map's elements stay where they are, so the reference outlives the lock
    }

    void forget(btDynamicsWorld& world) {
        const std::lock_guard<std::mutex> lock(mutex_);
        chains_.erase(&world);
    }

  private:
    std::mutex mutex_;  // worlds may step in different threads
    std::map<btDynamicsWorld*, Chain> chains_;
};

void runChain(btDynamicsWorld* world, btScalar dt) {
    const Chain& chain = ChainTable::instance().chainOf(*world);
    if (chain.applicationCallback) chain.applicationCallback(world, dt);
    for (std::size_t i = 0; i < chain.listeners.size(); ++i) chain.listeners[i]->preTick(dt);
}

}  // namespace

void listenToPreTick(btDynamicsWorld& world, PreTickListener& listener) {
    Chain& chain = ChainTable::instance().chainOf(world);
    const btInternalTickCallback current = PreTickSlot::of(world);
    if (current != runChain) {
        chain.applicationCallback = current;
        fillSlot(world, runChain);
    }
    chain.listeners.push_back(&listener);
}

void stopListeningToPreTick(btDynamicsWorld& world, PreTickListener& listener, bool worldIsAlive) {
    Chain& chain = ChainTable::instance().chainOf(world);
    chain.listeners.erase(std::remove(chain.listeners.begin(), chain.listeners.end(), &listener),
                          chain.listeners.end());
    // Someone who chained after us still calls runChain: then the entry must stay for it to find.
    const bool mayLeave = worldIsAlive && chain.listeners.empty() && PreTickSlot::of(world) == runChain;
    if (!mayLeave) return;
    fillSlot(world, chain.applicationCallback);
    ChainTable::instance().forget(world);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
