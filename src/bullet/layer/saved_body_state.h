// What a layer takes over of a body, and how the body gets it back.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/sheet/sheet_mechanics.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

class SavedBodyState {
  public:
    // Primes the body, keeps what it was, and orders its links by colour, and those of `mechanics` with them.
    SavedBodyState(btSoftBody& body, SheetMechanics& mechanics);

    // The same for the body as it is after a cut.
    // @param mechanics   of the body now, in the order of its links, which this changes
    // @param oldAreas    of the nodes that there were, m2
    // @param dryMasses   of all nodes, kg; 0 for a node without cloth
    void recut(btSoftBody& body, SheetMechanics& mechanics, const std::vector<double>& oldAreas,
               const std::vector<double>& dryMasses);

    // Switches Bullet's aero models off; what the application has set since is kept for the end.
    void silenceAero(btSoftBody& body);

    // Gives back masses, link constants, link order and aero model. Pins that the application has set or
    // taken out in the meantime are its decision: a freed node gets the mass in `dryMasses`, and links at
    // either get the constant that Bullet would give them.
    void restore(btSoftBody& body, const std::vector<double>& dryMasses) const;

  private:
    void orderLinks(btSoftBody& body, SheetMechanics& mechanics);

    std::vector<btScalar> inverseMasses_;
    std::vector<btScalar> linkConstants_;  // in the layer's order
    std::vector<int> linkOrder_;           // the application's link at each place
    btScalar drag_ = 0;
    btScalar lift_ = 0;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
