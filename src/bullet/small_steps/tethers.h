// Long-range attachments: a node cannot get farther from the nearest pin than the cloth between them allows.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/sheet/sheet_mechanics.h"
#include "bullet/small_steps/small_step_sheet.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Unilateral tethers (Kim et al. 2012, "Long range attachments"). Each is as long as the shortest way through
// the links, and as much longer as the cloth stretches by what hangs on it at rest, so that tethers take away
// the stretch that comes of too few steps, and leave the sheet's own.
class Tethers {
  public:
    // Lays tethers to the pins, if those have changed, and makes them as long as the water's weight asks for.
    // @param stretchTolerance  of SmallStepSettings, 1
    void begin(const btSoftBody& body, const SheetMechanics& mechanics, double stretchTolerance);
    void solve(SmallStepSheet& sheet) const;

  private:
    void lay(const SheetMechanics& mechanics);
    void measure(const SheetMechanics& mechanics, double gravity, double stretchTolerance);

    std::vector<int> pins_;
    std::vector<int> pinOf_;        // of each node; -1 for none
    std::vector<double> distance_;  // to it through the links, m
    std::vector<float> length_;     // of the tether, m
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
