// The law of every contact of wet cloth: faces do not pass each other, with Coulomb friction and adhesion.
#pragma once

#include <LinearMath/btVector3.h>

#include <algorithm>

#include "drench/config.h"

class btSoftBody;

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Makes a friction coefficient usable that an application has given to Bullet: negative or NaN friction counts as 0,
// and anything above 1000 as 1000, which holds whatever presses.
double usableFriction(double coefficient);

// Friction coefficient between the cloths of two bodies when dry: the larger of their m_cfg.kDF, made usable.
btScalar dryFriction(const btSoftBody& one, const btSoftBody& other);

// Traction of the bond between two cloths, N/m2, from what each has: both have to be wet, and as the nodes of either
// hold the other, they hold one half.
inline double adhesionTractionBetween(double one, double other) {
    return 0.5 * std::min(one, other);
}

// Whether a node is bonded. A bond forms where faces touch, and breaks where they are farther apart than it reaches.
// @param adhesion  force of the bond, in any unit; 0 for none
// @param isJoined  whether the faces touch, or were bonded before
// @param gap       between the faces, m, negative inside
inline bool adhesionHolds(double adhesion, bool isJoined, double gap, double reach) {
    return adhesion > 0 && isJoined && gap < reach;
}

// One contact in one step. Pushes and adhesion are of the same unit, whatever is proportional to a force: impulses, or
// how far they take a node.
struct ContactLaw {
    btScalar friction;  // Coulomb's coefficient
    btScalar adhesion;  // the largest pull that the bond holds; 0 without one

    // What holds the faces apart, or, below 0, together: all that is needed to close the gap, but no pull beyond
    // the adhesion.
    btScalar push(btScalar needed) const { return std::max(needed, -adhesion); }
    // The largest friction. What presses the faces together is what holds them apart: the push, and that against the
    // bond.
    btScalar maxFriction(btScalar push) const { return friction * (push + adhesion); }
};

// The part of a vector that is along a surface.
inline btVector3 alongSurface(const btVector3& vector, const btVector3& normal) {
    return vector - normal * vector.dot(normal);
}

// Friction, along the slip that it opposes, so to be subtracted; never more than stops the slip.
// @param slip      along the surface
// @param length    of the slip, above 0
// @param stopping  friction that would just stop it
inline btVector3 drag(const btVector3& slip, btScalar length, btScalar stopping, btScalar maxFriction) {
    return slip * (std::min(maxFriction, stopping) / length);
}

// How far cloths that overlap are taken apart at once, m, without a velocity: all at once would take cloth through
// cloth elsewhere.
// @param margin  of both together, m
template <typename Scalar>
Scalar liftAtOnce(Scalar depth, Scalar margin) {
    constexpr auto fraction = Scalar(0.1);
    return std::min(depth, fraction * margin);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
