#include "bullet/contact/near_solids.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <cmath>

#include "bullet/contact/solids.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

bool isJump(const Twist& motion, btScalar time) {
    const btScalar distance = motion.linear.length();
    return (distance > btScalar(NearSolids::jumpDistance) &&
            distance > btScalar(NearSolids::jumpSpeed) * time) ||
           motion.angular.length() > btScalar(NearSolids::jumpTurn);
}

// In how many substeps a body with a velocity makes a motion.
btScalar substepsFor(const Twist& motion, const Twist& perSubstep) {
    // Of a body that moves and turns, the larger of the two at an arm of a decimetre is the more exact one.
    constexpr auto arm = btScalar(0.1);
    const btScalar speed = perSubstep.linear.length(), spin = perSubstep.angular.length();
    return speed > arm * spin ? motion.linear.length() / speed : motion.angular.length() / spin;
}

int numberOf(const btCollisionObject& object) {
    return object.getBroadphaseHandle() ? object.getBroadphaseHandle()->m_uniqueId : -1;
}

}  // namespace

bool movesInStep(const btCollisionObject& object) {
    if (object.getInternalType() & btCollisionObject::CO_FEATHERSTONE_LINK) return true;
    return btRigidBody::upcast(&object) && !object.isStaticOrKinematicObject();
}

class NearSolids::Finder final : public btBroadphaseAabbCallback {
  public:
    explicit Finder(NearSolids& near) : near_(near) {}

    bool process(const btBroadphaseProxy* proxy) override {
        near_.add(*static_cast<const btCollisionObject*>(proxy->m_clientObject));
        return true;
    }

  private:
    NearSolids& near_;
};

void NearSolids::add(const btCollisionObject& object) {
    if (object.getInternalType() == btCollisionObject::CO_SOFT_BODY || movesInStep(object)) return;
    const SolidPath stays = {object.getWorldTransform(), object.getWorldTransform()};
    seen_.push_back({numberOf(object), &object, stays, stays, false});
}

void NearSolids::begin(const btSoftBody& sheet, Bounds bounds, double substep, bool hasJumped) {
    last_.swap(seen_);
    seen_.clear();
    constexpr double farEnough = 1;  // m
    bounds.grow(btScalar(std::max(farEnough, jumpSpeed * substep)));
    Finder finder(*this);
    if (sheet.m_worldInfo->m_broadphase)
        sheet.m_worldInfo->m_broadphase->aabbTest(bounds.low, bounds.high, finder);
    for (int i = 0; i < sheet.m_anchors.size(); ++i) add(*sheet.m_anchors[i].m_body);
    std::sort(seen_.begin(), seen_.end());
    seen_.erase(std::unique(seen_.begin(), seen_.end()), seen_.end());
    if (hasJumped) return;
    auto last = last_.begin();
    for (Seen& seen : seen_) {
        while (last != last_.end() && *last < seen) ++last;
        follow(seen, last != last_.end() && *last == seen ? &*last : nullptr, btScalar(substep));
    }
}

void NearSolids::observe(const btSoftBody& sheet) {
    Bounds bounds = {sheet.m_nodes[0].m_x, sheet.m_nodes[0].m_x};
    for (int n = 1; n < sheet.m_nodes.size(); ++n) bounds.take(sheet.m_nodes[n].m_x);
    begin(sheet, bounds, 0, true);
}

void NearSolids::follow(Seen& seen, const Seen* last, btScalar substep) {
    if (movingBody(*seen.object))
        return followKinematic(seen, last, velocitiesOf(*seen.object) * substep, substep);
    if (!last) return;
    const SolidPath path = {last->path.end, seen.path.end};
    if (!path.isMoving()) return;
    seen.hasJumped = isJump(path.motion(), substep);
    (seen.hasJumped ? seen.jump : seen.path) = path;
}

void NearSolids::followKinematic(Seen& seen, const Seen* last, const Twist& perSubstep, btScalar substep) {
    const btTransform& end = seen.path.end;
    const SolidPath whole = {last ? last->path.end : moved(end, perSubstep * -1), end};
    if (!whole.isMoving()) return;
    const Twist motion = whole.motion();
    // Bullet gives no velocity to a body whose interpolation transform was set, too: it was put there.
    const bool isPut = perSubstep.isZero();
    const btScalar substeps = last && !isPut ? substepsFor(motion, perSubstep) : 1;
    if (isPut || isJump(motion, std::max(substeps, btScalar(1)) * substep)) {
        seen.hasJumped = true;
        seen.jump = whole;
        return;
    }
    constexpr auto rounding = btScalar(0.01);
    if (substeps > 1 + rounding)
        seen.path = {whole.start, moved(whole.start, motion * (1 / std::round(substeps)))};
    else if (substeps > 1 - rounding)
        seen.path.start = moved(end, perSubstep * -1);  // the same as without a memory
    else
        seen.path.start = whole.start;
}

const NearSolids::Seen* NearSolids::find(const btCollisionObject& object) const {
    const SolidPath none = {};
    const Seen wanted = {numberOf(object), &object, none, none, false};
    const auto found = std::lower_bound(seen_.begin(), seen_.end(), wanted);
    return found != seen_.end() && *found == wanted ? &*found : nullptr;
}

SolidPath NearSolids::pathOf(const btCollisionObject& object) const {
    const Seen* const seen = find(object);
    return seen ? seen->path : SolidPath{object.getWorldTransform(), object.getWorldTransform()};
}

const SolidPath* NearSolids::jumpOf(const btCollisionObject& object) const {
    const Seen* const seen = find(object);
    return seen && seen->hasJumped ? &seen->jump : nullptr;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
