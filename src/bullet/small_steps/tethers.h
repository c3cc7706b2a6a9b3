// Long-range attachments: limit the distance of each node from the nearest pin.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/sheet/sheet_mechanics.h"
#include "bullet/small_steps/small_step_sheet.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Unilateral tethers (Kim et al. 2012, "Long range attachments"). The length of each is that of the shortest
// path along links, plus the stretch of the cloth under the weight that hangs on it at rest. So tethers
// remove the stretch that results from too few steps, but not the sheet's own.
class Tethers {
  public:
    // Assigns tethers to the nearest pins, if the pins have changed, and computes their lengths for the
    // present water.
    // @param stretchTolerance  of SmallStepSettings, dimensionless
    void begin(const btSoftBody& body, const SheetMechanics& mechanics, double stretchTolerance);
    void solve(SmallStepSheet& sheet) const;

  private:
    void lay(const SheetMechanics& mechanics);
    void measure(const SheetMechanics& mechanics, double gravity, double stretchTolerance);

    std::vector<int> pins_;
    std::vector<int> pinOf_;        // nearest pin of each node; -1 for none
    std::vector<double> distance_;  // from the pin along the links, m
    std::vector<float> length_;     // of the tether, m
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
