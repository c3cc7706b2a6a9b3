// Anchors between nodes of a sheet and solids.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/contact/near_solids.h"
#include "bullet/contact/solids.h"
#include "bullet/small_steps/small_step_sheet.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// The anchors of a body (btSoftBody::appendAnchor), solved in each small step.
class SheetAnchors {
  public:
    // Reads the anchors of the body, and where their solids start.
    void find(const btSoftBody& body, const NearSolids& near);
    // Adds the solids.
    void addSolids(const btSoftBody& body, const NearSolids& near, Solids& solids);
    // Computes the anchor points for the substep, and moves nodes to them without changing their velocity,
    // because a solid that cloth has pushed is at another position than at the end of the previous substep.
    void begin(const btSoftBody& body, SmallStepSheet& sheet, const Solids& solids);
    void solve(SmallStepSheet& sheet, Solids& solids) const;

  private:
    struct Tie {
        int anchor;  // index in the body
        int node;
        btTransform start;  // pose of the solid at the start of the substep
        std::size_t solid;  // index
        btVector3 arm;      // of the anchor point, see Solid
        btVector3 from;     // from the node to the anchor point at the start, m
        btScalar influence;
    };
    std::vector<Tie> ties_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
