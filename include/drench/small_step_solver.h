// Solver for Bullet's soft-body worlds that gives cloth its stiffness in N/m, so that its weight shows.
#pragma once

#include <BulletSoftBody/btDefaultSoftBodySolver.h>

#include <memory>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// Settings of a SmallStepSolver: into how many small steps it divides each of Bullet's substeps. ("Small step" is what
/// Macklin et al. call a substep; "substep" always means one of Bullet's.)
struct SmallStepSettings {
    /// Number of small steps per substep; 1 to 1000, or 0 (default): chosen automatically from `stretchTolerance` and
    /// the bending rigidity, at least 4, and so that no small step is longer than 4.2 ms of the sheet's own time. All
    /// sheets of a world use the largest number that any of them needs.
    ///
    /// Small steps may differ in length, because substeps do, or the number, or the timescale: a sheet has in all of
    /// them the stiffness that it has in the longest of the last 4 to 8 s, so it rests and hangs as in equal steps.
    /// It becomes softer at once where a longer step needs it, and stiffer over seconds. With a `count` that you set
    /// this is noticeable after a single long substep; with 0 all small steps are about equally long.
    int count = 0;

    /// Mean excess strain allowed in a hanging sheet, dimensionless; 1e-5 to 1; default 0.01.
    ///
    /// In a step of h seconds a link is at most about as stiff as m / h^2, with m the mass of a node. The mean strain
    /// of a sheet that hangs under its own weight is then too large by g H / 2 (h^2 / l^2 - rho / c), with H its
    /// height, l the length of a link, rho the areal density and c the stretch stiffness. So h is at most l sqrt(2
    /// tolerance / (g H) + rho / c). This is an estimate, with the sheet's longer side as H and the mean link as l: a
    /// sheet that hangs by points, or carries a load, strains more.
    ///
    /// The second limit is bending: the rigidity B is reached up to about h = 0.17 l^2 sqrt(rho / B), or 0.1 l^2
    /// sqrt(rho / B) with bending friction, which is stiffer until it slides. If `count` is set below what this needs,
    /// fine cloth bends too easily. l stands for what triangles on nine tenths of the area need: a few slivers do not
    /// determine the number of steps, and bend more easily instead.
    double stretchTolerance = 0.01;

    /// Whether each node has a tether to the nearest pin (Kim et al. 2012, "Long range attachments"), which limits the
    /// stretch of fine sheets in few steps; default false. The length of a tether is that of the shortest path to the
    /// pin along links, plus its stretch under the sheet's own weight (1.5 times an estimate that spreads the load
    /// evenly at each distance from the pins), plus `stretchTolerance`. A tether pulls the node only, not the pin.
    bool tethers = false;
};

/// Solves sheets that have a WetCloth in many small steps of one sweep each, inside each of Bullet's substeps (Macklin
/// et al. 2019, "Small steps in physics simulation"). One substep of the world, with Bullet's collision detection once,
/// is then as accurate as that many substeps. Links have the fabric's stiffness in N/m, triangles its bending rigidity
/// and bending friction, at their present moisture; contacts have Coulomb friction.
///
///     drench::SmallStepSolver solver;
///     btSoftRigidDynamicsWorld world(&dispatcher, &broadphase, &constraints, &configuration, &solver);
///
/// It must outlive the world. All other soft bodies, and sheets with pose matching (m_pose.m_bframe and kMT), are
/// solved by Bullet, bit-identically.
///
/// Body settings that are used:
/// - gravity (see `SheetSettings::ownGravity`), forces in m_f, pins, anchors with their influence, pressure and volume
///   (kPR, kVC), timescale. A pin that is moved through m_x moves at constant velocity during the substep;
/// - m_cfg.kDP as a rate, 1/s: the velocity is multiplied by exp(-kDP t) (Bullet: by 1 - kDP per substep);
/// - kDF times a solid's friction as the friction coefficient of dry cloth, unless WetCloth::setSurface was called for
///   the solid; between soft bodies the larger kDF. Water changes both, and adds adhesion;
/// - the margin, as the distance at which cloth rests on solids; convex hulls add their own. Layers of cloth rest at the
///   sum of both margins;
/// - rest lengths at the time when the WetCloth was made, times setRestLengthScale.
///
/// Body settings that are ignored: iterations, kVCF, hardness of contacts and anchors (kCHR, kKHR, kSHR, kAHR),
/// material stiffness, and links for bending, because triangles bend.
///
/// Solids of every kind push and carry cloth along the path on which they move within a substep: dynamic and kinematic
/// rigid bodies, links of a btMultiBody, and static bodies and ghosts that the application moves (ghosts only if they have
/// contact response). A frame may have several substeps. Rigid bodies and links react to the cloth: at the end of the
/// substep its impulses change their velocity, and their position unless other solids touch them. Shapes may be any but
/// planes and btSdfCollisionShape; triangles are taken from meshes and height fields as these are at the moment.
///
/// Sheets meet themselves and each other (see `SheetSettings::meetsItself` and `meetsSheets`): layers keep twice the
/// margin, or the sum of both, from each other, with friction and adhesion. Linear momentum is kept; friction, which
/// acts on both layers at that distance, takes a little of the angular momentum. Nodes that pass each other by more than
/// about a cell in a small step are not kept apart.
///
/// A solid that the application moves by more than 0.5 m from one frame to the next and at more than 30 m/s, or turns by
/// more than 120 degrees, has jumped: it is where it is now and pushes nothing on its way, and a sheet that is anchored to
/// it is carried along. The same holds for a kinematic body whose interpolation transform the application has set, too, and
/// for all solids around a sheet whose nodes it has all moved. `WetCloth::jumped` says so for anything else.
///
/// After the step m_rcontacts and m_scontacts contain its contacts. If a substep produces a position that is not finite, the sheet
/// stays where it was, with velocity 0; see SheetHealth.
class DRENCH_API SmallStepSolver final : public btDefaultSoftBodySolver {
  public:
    /// @throws std::invalid_argument for a count or tolerance out of range
    explicit SmallStepSolver(const SmallStepSettings& settings = {});
    ~SmallStepSolver() override;
    SmallStepSolver(const SmallStepSolver&) = delete;
    SmallStepSolver& operator=(const SmallStepSolver&) = delete;

    /// Settings given to the constructor.
    const SmallStepSettings& settings() const;
    /// Number of small steps of the last substep; 0 before the first, or without sheets.
    int steps() const;
    /// Instruction set of the inner loops: "AVX2", "baseline vectors" or "scalar".
    const char* kernels() const;

    /// @cond  Called by Bullet.
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
