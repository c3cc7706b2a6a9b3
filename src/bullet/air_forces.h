// Drag of the air on the faces of a body, in place of Bullet's aero models.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "drench/air.h"
#include "drench/precision.h"
#include "drench/wet_laws.h"
#include "pose.h"
#include "sheet_mechanics.h"
#include "small_step_kernels.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// The air of one sheet.
class AirForces {
  public:
    explicit AirForces(const RestShape& shape);

    /// Adds to the nodes' forces, per face, F = -1/2 rho A (C_n |u_n| u_n n + C_t |u_t| u_t), u the velocity
    /// of the face against the wind. Air leaks through the cloth: the pressure is that of the speed which is
    /// left after the leak, and the leak that of the pressure. The force is taken at the end of the substep
    /// (linearly implicit on the face's share of its nodes' mass), so it may stop the relative motion but
    /// never reverses it.
    void add(btSoftBody& body, const WetLaws& laws, const Air& air, const SheetMechanics& mechanics,
             const Pose& pose, double dt);

    /// The same as a change of the nodes' velocities, for a world that ignores forces on nodes.
    void push(btSoftBody& body, const WetLaws& laws, const Air& air, const SheetMechanics& mechanics,
              const Pose& pose, double dt);

  private:
    void evaluate(const WetLaws& laws, const Air& air, const SheetMechanics& mechanics, const Pose& pose,
                  double dt);

    std::vector<double> nodeAreas_;
    std::vector<FaceBlock> faces_;
    // Of each node, and a spare one; see SmallStepKernels::pushByAir.
    std::vector<MovingNode> positions_, velocities_, forces_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
