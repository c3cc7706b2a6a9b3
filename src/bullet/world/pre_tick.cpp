#include "bullet/world/pre_tick.h"

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

/// What happens at the start of a world's substeps.
struct Chain {
    /// The application's callbacks that were found in the slot, oldest first. The last one is the one to
    /// call. Should it have been chained by the application onto ours, it calls ours again and means the one
    /// before.
    std::vector<btInternalTickCallback> applicationCallbacks;
    std::size_t depth = 0;  // of such calls
    std::vector<PreTickListener*> listeners;
    bool callingListeners = false;
};

/// A tick callback is told its world and nothing else, and the world's user info belongs to the application:
/// this table is the only way from one to the other. It holds no settings and no state of a simulation. An
/// entry stays for as long as the program, since the world's slot may hold our callback that long.
class ChainTable {
  public:
    static ChainTable& instance() {
        // Never destroyed: a layer in a global variable may end after any static of ours.
        static ChainTable& table = *new ChainTable;
        return table;
    }

    Chain& chainOf(btDynamicsWorld& world) {
        const std::lock_guard<std::mutex> lock(mutex_);
        return chains_[&world];  // a map's elements stay where they are, so the reference outlives the lock
    }

  private:
    std::mutex mutex_;  // worlds may step in different threads
    std::map<btDynamicsWorld*, Chain> chains_;
};

void callApplication(Chain& chain, btDynamicsWorld* world, btScalar dt) {
    if (chain.depth >= chain.applicationCallbacks.size()) return;
    const btInternalTickCallback callback =
        chain.applicationCallbacks[chain.applicationCallbacks.size() - 1 - chain.depth];
    struct Deeper {
        std::size_t& depth;
        explicit Deeper(std::size_t& d) : depth(d) { ++depth; }
        ~Deeper() { --depth; }
        Deeper(const Deeper&) = delete;
        Deeper& operator=(const Deeper&) = delete;
    } const deeper(chain.depth);
    callback(world, dt);
}

void removeGone(Chain& chain) {
    chain.listeners.erase(std::remove(chain.listeners.begin(), chain.listeners.end(), nullptr),
                          chain.listeners.end());
}

void callListeners(Chain& chain, btScalar dt) {
    struct Calling {
        Chain& chain;
        explicit Calling(Chain& c) : chain(c) { chain.callingListeners = true; }
        ~Calling() {
            chain.callingListeners = false;
            removeGone(chain);
        }
        Calling(const Calling&) = delete;
        Calling& operator=(const Calling&) = delete;
    } const calling(chain);
    for (std::size_t i = 0; i < chain.listeners.size(); ++i)
        if (chain.listeners[i]) chain.listeners[i]->preTick(dt);
}

void runChain(btDynamicsWorld* world, btScalar dt) {
    Chain& chain = ChainTable::instance().chainOf(*world);
    callApplication(chain, world, dt);
    if (chain.depth == 0) callListeners(chain, dt);
}

}  // namespace

void listenToPreTick(btDynamicsWorld& world, PreTickListener& listener) {
    Chain& chain = ChainTable::instance().chainOf(world);
    const btInternalTickCallback current = PreTickSlot::of(world);
    if (current != runChain) {
        if (!current)
            chain.applicationCallbacks.clear();  // a new world where an old one was, or a callback withdrawn
        if (current) chain.applicationCallbacks.push_back(current);
        fillSlot(world, runChain);
    }
    chain.listeners.push_back(&listener);
}

void stopListeningToPreTick(btDynamicsWorld& world, PreTickListener& listener) {
    Chain& chain = ChainTable::instance().chainOf(world);
    std::replace(chain.listeners.begin(), chain.listeners.end(), &listener,
                 static_cast<PreTickListener*>(nullptr));
    if (!chain.callingListeners) removeGone(chain);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
