#include "bullet/world/ticks.h"

#include <BulletDynamics/Dynamics/btActionInterface.h>
#include <LinearMath/btAlignedObjectArray.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <vector>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// Bullet has setters for callbacks and actions but no getters; a derived class has access.
struct Hidden : btDiscreteDynamicsWorld {
    static btInternalTickCallback preTickOf(btDynamicsWorld& world) {
        return world.*(&Hidden::m_internalPreTickCallback);
    }
    static btInternalTickCallback postTickOf(btDynamicsWorld& world) {
        return world.*(&Hidden::m_internalTickCallback);
    }
    static bool hasAction(btDiscreteDynamicsWorld& world, btActionInterface* action) {
        const btAlignedObjectArray<btActionInterface*>& actions = world.*(&Hidden::m_actions);
        return actions.findLinearSearch(action) != actions.size();
    }
};

constexpr bool isPreTick = true;

}  // namespace

// Parts of a chain.
namespace ticks {

// Does nothing. A world that has this action is the one that got it, not a later world at the same address.
class WorldMark final : public btActionInterface {
  public:
    void updateAction(btCollisionWorld*, btScalar) override {}
    void debugDraw(btIDebugDraw*) override {}
};

// Listeners of one event. They may be added and removed while they are called.
class Listeners {
  public:
    bool has(TickListener& listener) const {
        return std::find(all_.begin(), all_.end(), &listener) != all_.end();
    }
    void add(TickListener& listener) { all_.push_back(&listener); }
    void remove(TickListener& listener) {
        std::replace(all_.begin(), all_.end(), &listener, static_cast<TickListener*>(nullptr));
        if (!isCalling_) removeGone();
    }
    void clear() { all_.clear(); }

    // Includes listeners that are added meanwhile.
    void call(void (TickListener::*tick)(btScalar), btScalar dt) {
        struct Calling {
            Listeners& listeners;
            explicit Calling(Listeners& some) : listeners(some) { listeners.isCalling_ = true; }
            ~Calling() {
                listeners.isCalling_ = false;
                listeners.removeGone();
            }
            Calling(const Calling&) = delete;
            Calling& operator=(const Calling&) = delete;
        } const calling(*this);
        for (std::size_t i = 0; i < all_.size(); ++i)
            if (all_[i]) (all_[i]->*tick)(dt);
    }

  private:
    void removeGone() { all_.erase(std::remove(all_.begin(), all_.end(), nullptr), all_.end()); }

    std::vector<TickListener*> all_;  // null for those removed while they are called
    bool isCalling_ = false;
};

// Pre-tick callbacks of the application that were found in the world's slot, oldest first.
class ApplicationCallbacks {
  public:
    void found(btInternalTickCallback callback) {
        if (!callback) return all_.clear();  // the application has removed its callback
        // If an earlier callback is set again, those set after it were removed.
        all_.erase(std::find(all_.begin(), all_.end(), callback), all_.end());
        all_.push_back(callback);
    }

    // Calls the newest. If the application has chained it onto ours, it calls ours again, and that call
    // continues with the next older one.
    void call(btDynamicsWorld* world, btScalar dt) {
        if (depth_ >= all_.size()) return;
        struct Deeper {
            std::size_t& depth;
            explicit Deeper(std::size_t& d) : depth(d) { ++depth; }
            ~Deeper() { --depth; }
            Deeper(const Deeper&) = delete;
            Deeper& operator=(const Deeper&) = delete;
        };
        const btInternalTickCallback callback = all_[all_.size() - 1 - depth_];
        const Deeper deeper(depth_);
        callback(world, dt);
    }
    bool areRunning() const { return depth_ > 0; }

  private:
    std::vector<btInternalTickCallback> all_;
    std::size_t depth_ = 0;  // number of nested calls
};

}  // namespace ticks

// Listeners and callbacks of one world.
struct Ticks::Chain {
    ticks::WorldMark mark;
    ticks::ApplicationCallbacks beforePreTick;
    ticks::Listeners atPreTick;
    btInternalTickCallback beforePostTick = nullptr;  // while our callback is in the slot
    ticks::Listeners atPostTick;                      // for the next post-tick only
};

// A tick callback gets only its world as argument, and the world's user info belongs to the application. So
// this table is the only way to find the chain of a world. A chain is kept until another world is made at the
// same address, because a world may hold our callback and our mark that long, and does not report its
// destruction.
class Ticks::Table {
  public:
    static Table& instance() {
        // Never destroyed, because a layer in a global variable may be destroyed after any static variable of
        // ours.
        static Table& table = *new Table;
        return table;
    }

    // Null for a world without a chain, also if an earlier world at the same address had one.
    std::shared_ptr<Chain> chainOf(btDynamicsWorld& world) {
        const std::lock_guard<std::mutex> lock(mutex_);
        const auto known = chains_.find(&world);
        if (known == chains_.end()) return nullptr;
        // Only a discrete world can have a chain.
        auto& discrete = static_cast<btDiscreteDynamicsWorld&>(world);
        return Hidden::hasAction(discrete, &known->second->mark) ? known->second : nullptr;
    }

    std::shared_ptr<Chain> makeChain(btDiscreteDynamicsWorld& world) {
        if (std::shared_ptr<Chain> known = chainOf(world)) return known;
        auto chain = std::make_shared<Chain>();
        // Not an override of addAction in a world of the application.
        world.btDiscreteDynamicsWorld::addAction(&chain->mark);
        const std::lock_guard<std::mutex> lock(mutex_);
        chains_[&world] = chain;
        return chain;
    }

  private:
    std::mutex mutex_;  // worlds may be stepped in different threads
    std::map<btDynamicsWorld*, std::shared_ptr<Chain>> chains_;
};

Ticks::Ticks(btDiscreteDynamicsWorld& world, TickListener& listener)
    : world_(world), listener_(listener), chain_(Table::instance().makeChain(world)) {}

Ticks::~Ticks() {
    chain_->atPreTick.remove(listener_);
    chain_->atPostTick.remove(listener_);
}

void Ticks::hearPreTicks() {
    const btInternalTickCallback current = Hidden::preTickOf(world_);
    if (current != runPreTick) {
        chain_->beforePreTick.found(current);
        world_.setInternalTickCallback(runPreTick, world_.getWorldUserInfo(), isPreTick);
    }
    chain_->atPreTick.add(listener_);
}

void Ticks::awaitPostTick() {
    const btInternalTickCallback current = Hidden::postTickOf(world_);
    if (current != runPostTick) {
        chain_->beforePostTick = current;
        world_.setInternalTickCallback(runPostTick, world_.getWorldUserInfo(), !isPreTick);
    }
    // It is already registered if the previous substep was not completed.
    if (!chain_->atPostTick.has(listener_)) chain_->atPostTick.add(listener_);
}

void Ticks::runPreTick(btDynamicsWorld* world, btScalar dt) {
    const std::shared_ptr<Chain> chain = Table::instance().chainOf(*world);
    if (!chain) return;
    chain->beforePreTick.call(world, dt);
    if (!chain->beforePreTick.areRunning()) chain->atPreTick.call(&TickListener::preTick, dt);
}

void Ticks::runPostTick(btDynamicsWorld* world, btScalar dt) {
    const std::shared_ptr<Chain> chain = Table::instance().chainOf(*world);
    if (!chain) return;
    const btInternalTickCallback callback = chain->beforePostTick;
    world->setInternalTickCallback(callback, world->getWorldUserInfo(), !isPreTick);
    if (callback) callback(world, dt);
    chain->atPostTick.call(&TickListener::postTick, dt);
    chain->atPostTick.clear();
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
