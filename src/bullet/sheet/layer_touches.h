// What a sheet touches, as the SmallStepSolver has found it at the end of its last substep.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "drench/config.h"
#include "water/layer_contacts.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

class BulletPass;

struct LayerTouches {
    // The other cloths, by address only: LayerContact::with is 1 for the first.
    std::vector<const btSoftBody*> others;
    std::vector<LayerContact> contacts;
    bool areListed = false;  // whether a SmallStepSolver lists them

    void begin();
    // The number of another cloth, which is added if it is not there.
    int numberOf(const btSoftBody& other);
    // Forgets the contacts with another cloth.
    void forget(const btSoftBody& other);

    // @param nodes  number of nodes of the sheet
    void state(BulletPass& pass, std::size_t nodes);
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
