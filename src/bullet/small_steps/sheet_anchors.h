// Nodes of a sheet that are tied to solids.
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
    // Takes up the solids of the body's anchors.
    void find(const btSoftBody& body, Solids& solids);
    // Places them for the substep, and takes nodes to where they are tied, without a velocity of their own: a
    // solid that cloth has pushed is then elsewhere than the substep before has left it.
    void begin(const btSoftBody& body, SmallStepSheet& sheet, const Solids& solids);
    void solve(SmallStepSheet& sheet, Solids& solids) const;

  private:
    struct Tie {
        std::size_t solid;
        int anchor;  // of the body
        int node;
        btVector3 arm;   // from the solid's centre of mass, in the middle of the substep
        btVector3 from;  // from the node at its start to there, m
        btScalar influence;
    };
    std::vector<Tie> ties_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
