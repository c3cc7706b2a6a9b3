// A solver for Bullet's soft-body worlds in which cloth has its weight.
#pragma once

#include <BulletSoftBody/btDefaultSoftBodySolver.h>

#include <memory>

#include "drench/export.h"
#include "drench/precision.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// How a SmallStepSolver divides Bullet's substeps.
struct SmallSteps {
    /// Small steps in each substep, 1 to 1000. 0, the default: as many as `stretchTolerance` and the bending
    /// of the cloth ask for, at least 4, and of all sheets in a world as many as for the one that needs most.
    int count = 0;

    /// Mean strain that a hanging sheet may show beyond its own, 1; 1e-5 to 1. Default 0.01.
    ///
    /// A link that a step of h seconds is too long for acts as soft as m / h^2, m the mass of a node. Under
    /// its own weight a sheet of height H, link length l, areal density rho and stretch stiffness c then
    /// strains on average by g H / 2 (h^2 / l^2 - rho / c) too much, so the step is at most
    /// l sqrt(2 tolerance / (g H) + rho / c). An estimate, by the sheet's longer side and its mean link: a
    /// sheet hung by points, or with something else hanging on it, strains more.
    ///
    /// Bending has its rigidity B up to about h = 0.17 l^2 sqrt(rho / B), or 0.1 l^2 sqrt(rho / B) with
    /// bending friction, which is stiffer still until it slides; that is the other limit. With a count that is
    /// set lower, fine cloth is limp.
    double stretchTolerance = 0.01;

    /// Whether nodes are tethered to the nearest pin (Kim et al. 2012, "Long range attachments"), so that fine
    /// sheets hold together in few steps. A tether is as long as the way to the pin through the links, longer
    /// by what the sheet's own weight stretches it (1.5 times an estimate in which the load is spread evenly
    /// at each distance from the pins) and by `stretchTolerance`. It pulls the node only; pins feel nothing.
    /// Sheets without pins have none. Default false.
    bool tethers = false;
};

/// Moves the sheets of WetCloths in many small steps, each of one sweep, inside each of Bullet's substeps
/// (Macklin et al. 2019, "Small steps in physics simulation"): one long substep of the world, with Bullet's
/// collision detection once, is then as good as that many substeps. Links have the fabric's stiffness in N/m,
/// triangles its bending rigidity and bending friction, all as wet as they are; contacts are Coulomb's.
///
///     drench::SmallStepSolver solver;
///     btSoftRigidDynamicsWorld world(&dispatcher, &broadphase, &constraints, &configuration, &solver);
///
/// It must outlive the world. All other soft bodies, and sheets with pose matching (m_pose.m_bframe and kMT),
/// go Bullet's own way.
///
/// What counts of a sheet's own settings: gravity of the world info, forces in m_f, pins (one that is moved by
/// m_x goes there evenly), anchors with their influence, pressure and volume (kPR, kVC), timescale, and
/// - m_cfg.kDP is a rate, 1/s: the sheet keeps exp(-kDP t) of its velocity (stock Bullet takes a share per
///   substep);
/// - kDF times a solid's friction is the friction coefficient of dry cloth, but for solids that WetCloth::setSurface
///   says more of; between soft bodies it is the larger kDF. Water changes both, and makes cloth cling;
/// - the margin is the distance at which cloth rests on things; convex hulls add their own;
/// - rest lengths are those when the WetCloth was made, times setRestLengthScale.
/// Iterations, kVCF, hardness of contacts and anchors (kCHR, kKHR, kSHR, kAHR) and material stiffness play no
/// part, nor do links that bend, as the triangles bend.
///
/// Solids that are dynamic feel the cloth: what pushes them in a substep changes their velocity, and their
/// place unless other solids touch them, at its end. Links of a btMultiBody are met as if they stood still, and
/// feel nothing.
/// After the step m_rcontacts and m_scontacts hold what was touched in it. A substep that comes to something
/// not finite leaves the sheet where it was, at rest; see SheetHealth.
class DRENCH_API SmallStepSolver final : public btDefaultSoftBodySolver {
  public:
    /// @throws std::invalid_argument for a count or tolerance out of range
    explicit SmallStepSolver(const SmallSteps& settings = {});
    ~SmallStepSolver() override;
    SmallStepSolver(const SmallStepSolver&) = delete;
    SmallStepSolver& operator=(const SmallStepSolver&) = delete;

    /// What it was made with.
    const SmallSteps& settings() const;
    /// Small steps of the last substep; 0 before the first, or without sheets.
    int steps() const;
    /// The loops in use: "AVX2", "baseline vectors" or "scalar".
    const char* kernels() const;

    /// @cond  What Bullet calls.
    void predictMotion(btScalar substep) override;
    void solveConstraints(btScalar substep) override;
    void updateSoftBodies() override;
    void processCollision(btSoftBody* body, const btCollisionObjectWrapper* solid) override;
    void processCollision(btSoftBody* body, btSoftBody* other) override;
    /// @endcond

  private:
    struct DRENCH_LOCAL State;
    std::unique_ptr<State> state_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
