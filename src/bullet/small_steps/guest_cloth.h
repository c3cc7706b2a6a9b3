// A soft body that Bullet moves, as sheets meet it in small steps.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <array>
#include <memory>
#include <vector>

#include "bullet/cloth_contact/surface_tree.h"
#include "bullet/simd/nodes.h"
#include "bullet/small_steps/contact_memory.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Bullet has already moved its nodes for the whole substep. Here they go the same way in small steps, and react to
// contacts; what those change is added to what Bullet has found.
class GuestCloth {
  public:
    // Reads the body. @param fraction  of a small step in the substep
    void begin(const btSoftBody& body, float fraction);
    // Moves the nodes by a small step.
    void advance();
    // Adds positions and velocities to the body. @param smallStep  s
    void finish(btSoftBody& body, double smallStep) const;

    const btVector3& origin() const { return origin_; }
    const std::vector<MovingNode>& start() const { return start_; }
    std::vector<MovingNode>& moved() { return moved_; }
    std::vector<MovingNode>& movedBefore() { return before_; }
    const std::vector<char>& isCarried() const { return isCarried_; }
    // Displacements by Bullet in the substep, m.
    const std::vector<MovingNode>& own() const { return own_; }
    SurfaceTree& tree() { return *tree_; }

    ContactMemory memory;

  private:
    bool isSameCloth(const btSoftBody& body) const;
    void makeTree(const btSoftBody& body);

    std::vector<std::array<int, 3>> triangles_;
    std::unique_ptr<SurfaceTree> tree_;
    btVector3 origin_ = btVector3(0, 0, 0);
    std::vector<MovingNode> start_, own_, moved_;
    std::vector<MovingNode> before_;  // moved_ at the start of the current small step
    std::vector<char> isCarried_;     // false: their solids are Bullet's
    float fraction_ = 0;
    bool isFirstStep_ = true;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
