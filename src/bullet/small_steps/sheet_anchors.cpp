#include "bullet/small_steps/sheet_anchors.h"

#include "bullet/sheet/rest_shape.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

void SheetAnchors::find(const btSoftBody& body, const NearSolids& near) {
    ties_.clear();
    for (int i = 0; i < body.m_anchors.size(); ++i) {
        const btSoftBody::Anchor& anchor = body.m_anchors[i];
        ties_.push_back({i,
                         indexOf(body, anchor.m_node),
                         near.pathOf(*anchor.m_body).start,
                         0,
                         {0, 0, 0},
                         {0, 0, 0},
                         anchor.m_influence});
    }
}

void SheetAnchors::addSolids(const btSoftBody& body, const NearSolids& near, Solids& solids) {
    for (Tie& tie : ties_) {
        btRigidBody& solid = *body.m_anchors[tie.anchor].m_body;
        const btTransform end = movesInStep(solid) ? solid.getWorldTransform() : near.pathOf(solid).end;
        tie.solid = solids.add(solid, {tie.start, end});
    }
}

void SheetAnchors::begin(const btSoftBody& body, SmallStepSheet& sheet, const Solids& solids) {
    for (Tie& tie : ties_) {
        const btTransform& start = solids[tie.solid].path().start;
        tie.arm = start.getBasis() * body.m_anchors[tie.anchor].m_local;
        tie.from = start.getOrigin() + tie.arm - sheet.startPosition(static_cast<std::size_t>(tie.node));
        const auto node = static_cast<std::size_t>(tie.node);
        // A node with less influence hangs below its anchor; moving it up again and again would never let it rest.
        if (!(sheet.moved(node).inverseMass > 0) || tie.influence < 1) continue;
        sheet.place(node, tie.from + solids[tie.solid].displacement(tie.arm));
    }
}

void SheetAnchors::solve(SmallStepSheet& sheet, Solids& solids) const {
    for (const Tie& tie : ties_) {
        const auto influence = btScalar(sheet.fractionOf(double(tie.influence)));
        MovingNode& node = sheet.moved(static_cast<std::size_t>(tie.node));
        Solid& solid = solids[tie.solid];
        const btVector3 gap = tie.from + solid.displacement(tie.arm) - vectorOf(node);
        const btScalar length = gap.length(), inverseMass = btScalar(node.inverseMass);
        if (!(length > 0)) continue;
        const btScalar response = inverseMass + solid.response(tie.arm, gap / length);
        if (!(response > 0)) continue;
        const btVector3 push = gap * (influence / response);
        shift(node, push * inverseMass);
        solid.push(tie.arm, -push);
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
