// Saves what a layer changes on a body, and restores it.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/sheet/sheet_mechanics.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

class SavedBodyState {
  public:
    // Primes the body, saves its state, and sorts its links and those of `mechanics` by graph colouring.
    SavedBodyState(btSoftBody& body, SheetMechanics& mechanics);

    // Adapts to the body after a cut.
    // @param mechanics   of the present body; its links are reordered
    // @param oldAreas    of the nodes before the cut, m2
    // @param dryMasses   of all nodes, kg; 0 for a node without cloth
    void recut(btSoftBody& body, SheetMechanics& mechanics, const std::vector<double>& oldAreas,
               const std::vector<double>& dryMasses);

    // Switches Bullet's aero models off. Values that the application has set since are saved for `restore`.
    void silenceAero(btSoftBody& body);

    // Restores masses, link constants, link order and aero model. Pins that the application has set or
    // removed meanwhile are kept: an unpinned node gets the mass in `dryMasses`, and links next to changed
    // pins get the constant that Bullet would compute.
    void restore(btSoftBody& body, const std::vector<double>& dryMasses) const;

  private:
    void orderLinks(btSoftBody& body, SheetMechanics& mechanics);

    std::vector<btScalar> inverseMasses_;
    std::vector<btScalar> linkConstants_;  // in the layer's order
    std::vector<int> linkOrder_;           // index of the application's link at each index
    btScalar drag_ = 0;
    btScalar lift_ = 0;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
