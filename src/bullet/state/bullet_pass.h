// A StatePass that knows Bullet's types.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletSoftBody/btSoftBody.h>

#include <unordered_map>
#include <vector>

#include "drench/config.h"
#include "state/state_pass.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Identifies other bodies by their index in the world's list of collision objects. Classes that know Bullet
// have a function `state(BulletPass&)` in place of `state(StatePass&)`.
class BulletPass : public StatePass {
  public:
    BulletPass(StateWriter& writer, const btCollisionWorld& world) : StatePass(writer), world_(world) {
        nameAll();
    }
    BulletPass(StateReader& reader, Kind kind, const btCollisionWorld& world)
        : StatePass(reader, kind), world_(world) {}

    template <typename Part>
    void part(Part& part) {
        part.state(*this);
    }

    // A vector of a moving body: finite, and small enough that Bullet's sums are finite.
    static constexpr double farthest = 1e15;
    using StatePass::vector;
    void vector(btVector3& value, double max = farthest);
    void matrix(btMatrix3x3& value);
    // A packed node of any kind.
    template <typename Node>
    void node(Node& value) {
        auto& [x, y, z, fourth] = value;
        for (float* part : {&x, &y, &z, &fourth}) number(*part, -1e9, 1e9);
    }
    // The first `count` of them.
    template <typename Node>
    void nodes(std::vector<Node>& values, std::size_t count) {
        for (std::size_t n = 0; n < count; ++n) node(values[n]);
    }

    enum class Which { solid, soft };
    // An object, by address only; null if it was destroyed.
    // @return the object that was saved, or is being saved
    const btCollisionObject* object(const btCollisionObject* now, Which which);
    // Whether an object is in the world, by its address alone. @pre a pass that saves
    bool knows(const btCollisionObject* object) const { return indices_.count(object) > 0; }
    // The soft body to which a face belongs; null if that body is in no world.
    const btSoftBody* ownerOf(const btSoftBody::Face* face) const;

  private:
    void nameAll();
    const btCollisionObject* readObject(Which which);

    const btCollisionWorld& world_;
    std::unordered_map<const btCollisionObject*, int> indices_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
