// Converts stiffness in N/m into the link constants of Bullet's stock solver.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include "bullet/sheet/sheet_mechanics.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Up to this value of w k dt^2, with w the sum of the inverse masses and k in N/m, one sweep per substep
// gives a link its stiffness.
inline constexpr double resolvedStiffness = 2;

// The link constant m_c0 with which `sweeps` sweeps in a substep `dt` act as a spring of `stiffness` N/m
// between nodes whose inverse masses add up to `inverseMass`.
//
// One sweep: max(w, w/2 + 1/(k dt^2)). XPBD (Macklin et al. 2016, eq. 18) has w + 1/(k dt^2). With it a link
// is correct at the moment when it is solved; but its neighbours, solved later, stretch it again, on average
// over the colours by half of w times its own force. Subtracting that half makes the link correct at the end
// of the sweep. The lower limit is Bullet's stiffest link, which corrects all of its stretch at once.
//
// More sweeps: w / (1 - (1 + w k dt^2)^(-1/n)). A sweep corrects the fraction w / m_c0 of a stretch, so n
// sweeps leave (1 - w / m_c0)^n; a spring in an implicit step leaves 1 / (1 + w k dt^2).
double linkConstant(double inverseMass, double stiffness, double dt, int sweeps);

// Sets m_c0 of every link from its stiffness and the inverse masses of its nodes, for a substep of dt s.
void writeLinkConstants(btSoftBody& body, const SheetMechanics& mechanics, double dt);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
