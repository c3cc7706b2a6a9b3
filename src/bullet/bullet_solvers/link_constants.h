// Writes stiffness in N/m into the constants of a body's links, the way Bullet's stock solver takes it.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include "bullet/sheet/sheet_mechanics.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Up to this w k dt^2 one sweep a substep gives a link its stiffness: w the sum of its inverse masses, k
// N/m.
inline constexpr double resolvedStiffness = 2;

// The link constant m_c0 with which `sweeps` sweeps in a substep `dt` act as a spring of `stiffness` N/m
// between nodes whose inverse masses add up to `inverseMass`.
//
// One sweep: max(w, w/2 + 1/(k dt^2)). XPBD (Macklin et al. 2016, eq. 18) has w + 1/(k dt^2), which leaves a
// link right the moment it is solved; its neighbours, solved later, then stretch it again by what they take,
// on average over the colours half of w times its own force. Leaving that half out puts the link right at
// the end of the sweep. The limit is Bullet's own hardest link, which takes all of its stretch back at once.
//
// More sweeps: w / (1 - (1 + w k dt^2)^(-1/n)). A sweep takes back the share w / m_c0 of a stretch, so n of
// them leave (1 - w / m_c0)^n; a spring in an implicit step leaves 1 / (1 + w k dt^2).
double linkConstant(double inverseMass, double stiffness, double dt, int sweeps);

// Sets m_c0 of every link from its stiffness and the inverse masses of its nodes, for a substep of dt s.
void writeLinkConstants(btSoftBody& body, const SheetMechanics& mechanics, double dt);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
