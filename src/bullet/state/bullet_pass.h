// The pass over a state that knows Bullet.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletSoftBody/btSoftBody.h>

#include <unordered_map>
#include <vector>

#include "drench/config.h"
#include "state/state_pass.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Names other bodies by their place in the world's list of collision objects; `state(BulletPass&)` is for classes that
// know Bullet what `state(StatePass&)` is for others.
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

    // Of a body that moves, finite and not so large that Bullet's sums were not.
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
    // The first so many of them.
    template <typename Node>
    void nodes(std::vector<Node>& values, std::size_t count) {
        for (std::size_t n = 0; n < count; ++n) node(values[n]);
    }

    enum class Which { solid, soft };
    // An object, by its address alone; it may be gone, and is then none.
    // @return the one that was saved, or is being saved
    const btCollisionObject* object(const btCollisionObject* now, Which which);
    // Whether an object is in the world, by its address alone. @pre a pass that saves
    bool knows(const btCollisionObject* object) const { return indices_.count(object) > 0; }
    // The soft body that a face is of; none for one that is of no body in the world.
    const btSoftBody* ownerOf(const btSoftBody::Face* face) const;

  private:
    void nameAll();
    const btCollisionObject* readObject(Which which);

    const btCollisionWorld& world_;
    std::unordered_map<const btCollisionObject*, int> indices_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
