// Bullet's plain world with Drench's solver for its sheets.
#pragma once

#include <drench/drench.h>

#include "world/bullet_world.h"

namespace drench::demo {

/// A solver that is there before the world, and after it.
class OwnSolver {
  protected:
    explicit OwnSolver(const SmallSteps& settings) : solver_(settings) {}
    SmallStepSolver solver_;
};

class SmallStepWorld final : private OwnSolver, public BulletWorld {
  public:
    explicit SmallStepWorld(const SmallSteps& settings) : OwnSolver(settings), BulletWorld(&solver_) {}

    /// One: the solver divides it as it needs to.
    int substepsFor(double, double, int) const override { return 1; }
    /// The solver takes kDP as a rate.
    void damp(btSoftBody& sheet, double rate, double) const override { sheet.m_cfg.kDP = btScalar(rate); }
    int smallSteps() const override { return solver_.steps(); }
    std::string stepsName() const override { return "Small steps per frame of 1/60 s, in one substep"; }
};

}  // namespace drench::demo
