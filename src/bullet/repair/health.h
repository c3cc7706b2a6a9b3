// Computes the mechanical diagnostics of a sheet from its body.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include "bullet/sheet/sheet_mechanics.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

bool isFinite(const btSoftBody& body);
// The largest |length / rest length - 1| of all links that are not marked as bending.
double largestStrain(const btSoftBody& body, const SheetMechanics& mechanics);
// The largest depth of a node inside a solid that it touches, m; 0 if no node is inside.
double deepestPenetration(const btSoftBody& body);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
