// Tells each sheet what it touches at the end of a substep, for its water.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/contact/solids.h"
#include "bullet/sheet/sheet_mechanics.h"
#include "bullet/small_steps/moving_sheet.h"
#include "bullet/small_steps/surface_contacts.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

struct TouchingSheet {
    const btSoftBody* body;
    SheetMechanics* mechanics;
    const MovingSheet* sheet;
};

// @param sheets    that small steps have moved
// @param sleeping  sheets that have not moved, but may be touched
void listTouches(const std::vector<TouchingSheet>& sheets, const std::vector<SheetMechanics*>& sleeping,
                 const SurfaceContacts& contacts, const Solids& solids);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
