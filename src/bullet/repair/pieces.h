// Reports sheets that fall apart because their mesh is in several pieces.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include "bullet/repair/diagnostics.h"
#include "bullet/sheet/rest_shape.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Reports a body whose faces are in several pieces, which neither faces nor links join. Changes nothing.
void reportPieces(const btSoftBody& body, const RestShape& shape, Diagnostics& diagnostics);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
