// Contact law of wet cloth: no penetration, Coulomb friction and adhesion.
#pragma once

#include <LinearMath/btVector3.h>

#include <algorithm>

#include "drench/config.h"

class btSoftBody;

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Limits a friction coefficient that an application has given to Bullet: negative or NaN counts as 0, above
// 1000 as 1000.
double usableFriction(double coefficient);

// Dry friction coefficient between two cloths: the larger of the two m_cfg.kDF, limited by usableFriction.
btScalar dryFriction(const btSoftBody& one, const btSoftBody& other);

// Adhesive force per area between two cloths, N/m2, from the values of both. Both must be wet. Each contact
// is found from both sides, so each side holds half of the smaller value.
inline double adhesionTractionBetween(double one, double other) {
    return 0.5 * std::min(one, other);
}

// Whether adhesion holds a node. An adhesive bond forms where faces touch, and breaks when their gap exceeds
// its reach.
// @param adhesion  adhesive force, in any unit; 0 for none
// @param isJoined  whether the faces touch, or adhered before
// @param gap       between the faces, m; negative inside
inline bool adhesionHolds(double adhesion, bool isJoined, double gap, double reach) {
    return adhesion > 0 && isJoined && gap < reach;
}

// One contact in one step. Push and adhesion have the same unit, which may be anything proportional to a
// force, such as an impulse or the displacement that it causes.
struct ContactLaw {
    btScalar friction;  // Coulomb friction coefficient
    btScalar adhesion;  // largest adhesive pull; 0 without adhesion

    // Normal force between the faces, negative for a pull: what is needed to close the gap, but no pull above
    // the adhesion.
    btScalar push(btScalar needed) const { return std::max(needed, -adhesion); }
    // Largest friction. The faces are pressed together by the push and by the adhesion.
    btScalar maxFriction(btScalar push) const { return friction * (push + adhesion); }
};

// Component of a vector along a surface.
inline btVector3 alongSurface(const btVector3& vector, const btVector3& normal) {
    return vector - normal * vector.dot(normal);
}

// Friction along the slip, to be subtracted from the motion; at most the value that stops the slip.
// @param slip      along the surface
// @param length    of the slip, above 0
// @param stopping  friction that would just stop the slip
inline btVector3 drag(const btVector3& slip, btScalar length, btScalar stopping, btScalar maxFriction) {
    return slip * (std::min(maxFriction, stopping) / length);
}

// Distance by which overlapping cloths are separated in one step, m, without adding velocity. Separating them
// completely could push cloth through other cloth.
// @param margin  sum of both margins, m
template <typename Scalar>
Scalar liftAtOnce(Scalar depth, Scalar margin) {
    constexpr auto fraction = Scalar(0.1);
    return std::min(depth, fraction * margin);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
