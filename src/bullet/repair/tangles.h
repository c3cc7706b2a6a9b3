// Faces of a sheet that cross, and the trouble that this is.
#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/cloth_contact/crossings.h"
#include "bullet/repair/diagnostics.h"
#include "bullet/sheet/sheet_mechanics.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Pairs of faces that cross.
struct CrossingCount {
    int ofItself = 0;    // of the sheet with itself
    int withOthers = 0;  // with other sheets
    int firstNode = -1;  // of the first face that crosses another of the sheet, or of another sheet
    bool areAll = true;  // whether the search did not end at a limit
};

// Finds the crossings of sheets from their bodies.
class CrossingSearch {
  public:
    // @pre the body fits its mechanics and is finite
    // @param others  further sheets of the world, each with its mechanics
    // @param looksEverywhere  see Crossings::findWithin
    CrossingCount count(btSoftBody& body, SheetMechanics& mechanics, const std::vector<btSoftBody*>& others,
                        const CrossingLimits& limits, bool looksEverywhere);

  private:
    SurfaceTree& follow(btSoftBody& body, SheetMechanics& mechanics, const btVector3& origin);

    Crossings crossings_;
    std::vector<MovingNode> positions_, still_;
};

// The sheets of a world with which a sheet may cross: those whose bounds overlap, which have a WetCloth, fit it and are
// finite. @pre the world exists
std::vector<btSoftBody*> sheetsNear(btDiscreteDynamicsWorld& world, const btSoftBody& body);

// Looks for crossings now and then, and reports what lasts.
class TangleCheck {
  public:
    // @param bodyStep  s. With OnTrouble::throwError it throws, but looks again in the next substep
    void step(btDiscreteDynamicsWorld& world, btSoftBody& body, SheetMechanics& mechanics, double bodyStep,
              Diagnostics& diagnostics);

  private:
    double untilNext_ = 0;  // s
    int lasting_ = 0;       // looks in a row that found a tangle
    CrossingSearch search_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
