// A sheet that small steps move, with what it meets, while a substep lasts.
#pragma once

#include "bullet/small_steps/sheet_anchors.h"
#include "bullet/small_steps/small_step_sheet.h"
#include "bullet/small_steps/solid_contacts.h"
#include "bullet/small_steps/tethers.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

struct MovingSheet {
    explicit MovingSheet(const SheetMechanics& mechanics) : cloth(mechanics, bestKernels()) {}

    const btSoftBody::Node* nodes = nullptr;  // where Bullet had them as the substep began
    SmallStepSheet cloth;
    SolidContacts contacts;
    SheetAnchors anchors;
    Tethers tethers;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
