// Anchors between nodes of a sheet and solids.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/contact/solids.h"
#include "bullet/small_steps/small_step_sheet.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// The anchors of a body (btSoftBody::appendAnchor), solved in each small step.
class SheetAnchors {
  public:
    // Reads the anchors of the body, and adds their solids.
    void find(const btSoftBody& body, Solids& solids);
    // Computes the anchor points for the substep, and moves nodes to them without changing their velocity,
    // because a solid that cloth has pushed is at another position than at the end of the previous substep.
    void begin(const btSoftBody& body, SmallStepSheet& sheet, const Solids& solids);
    void solve(SmallStepSheet& sheet, Solids& solids) const;

  private:
    struct Tie {
        std::size_t solid;
        int anchor;  // index in the body
        int node;
        btVector3 arm;   // from the solid's centre of mass, in the middle of the substep
        btVector3 from;  // from the node to the anchor point at the start, m
        btScalar influence;
    };
    std::vector<Tie> ties_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
