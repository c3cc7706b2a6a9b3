// Reads the state of health of a sheet off its body.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include "bullet/sheet/sheet_mechanics.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

bool isFinite(const btSoftBody& body);
// The largest |length / rest length - 1| of links that do not bend.
double largestStrain(const btSoftBody& body, const SheetMechanics& mechanics);
// How deep the deepest node is in a solid that it touches, m; 0 if none is inside.
double deepestPenetration(const btSoftBody& body);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
