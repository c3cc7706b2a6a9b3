// A sheet with its contacts, while small steps move it within a substep.
#pragma once

#include "bullet/small_steps/contact_memory.h"
#include "bullet/small_steps/sheet_anchors.h"
#include "bullet/small_steps/small_step_sheet.h"
#include "bullet/small_steps/solid_contacts.h"
#include "bullet/small_steps/tethers.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

struct MovingSheet {
    explicit MovingSheet(const SheetMechanics& mechanics) : cloth(mechanics, bestKernels()) {}

    const btSoftBody::Node* nodes = nullptr;  // address of Bullet's array at the start of the substep
    SmallStepSheet cloth;
    SolidContacts contacts;
    SheetAnchors anchors;
    Tethers tethers;
    ContactMemory memory;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
