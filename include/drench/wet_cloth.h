// The layer: puts water into a btSoftBody and lets it show.
#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <Eigen/Core>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "drench/air.h"
#include "drench/drop.h"
#include "drench/export.h"
#include "drench/fabric.h"
#include "drench/ledger.h"
#include "drench/moisture.h"
#include "drench/precision.h"
#include "drench/snapshot.h"
#include "drench/source.h"
#include "drench/step_times.h"
#include "drench/surface.h"
#include "drench/wet_laws.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// Who calls `WetCloth::preSubstep`.
enum class Stepping {
    /// The world, through its pre-tick callback. Set a pre-tick callback of your own before the world's first
    /// WetCloth; it then runs first in each substep. One set later takes the slot, and the layer sleeps until
    /// the next WetCloth.
    byWorld,
    /// The application, at the start of each substep. The world's pre-tick callback stays untouched.
    byApplication
};

/// Settings of one sheet in one world.
struct SheetSettings {
    /// Material coordinates (u along the warp, v along the weft) of each node, m. Empty: the sheet as it lies
    /// when attached, which must be nearly flat, seen square to its best plane, with the warp along the
    /// body's first link. To attach again to a sheet that hangs in folds, give the `materialCoordinates()` of
    /// the WetCloth before.
    std::vector<Eigen::Vector2d> materialCoordinates;

    /// Instead, for cloth with seams, such as a sleeve: material coordinates of the three corners of each of
    /// the body's faces, m. Neighbours need not agree but in the length of the side between them. See
    /// `wrappedCoordinates`.
    std::vector<std::array<Eigen::Vector2d, 3>> faceCoordinates;

    /// How much faster water runs than the body's own time, 1; 0 to 1e5. Default 1. At 60 an hour of drying
    /// takes a minute. Sources run with the water; what they throw at the body pushes it as in its own time.
    double waterSpeed = 1;

    /// Default: by the world.
    Stepping stepping = Stepping::byWorld;
};

/// How a sheet does mechanically, as of now.
struct SheetHealth {
    /// Whether all positions and velocities of the body are finite. If not, the next step throws.
    bool finite;
    /// The largest |length / rest length - 1| of a stretch or shear link, 1.
    double largestStrain;
    /// How deep the deepest node is in a solid that it touched in the last substep, m; 0 if none is inside.
    double deepestPenetration;
    /// `WetCloth::stepBound`, s.
    double stepBound;
    /// Small steps of the last substep; 0 where no SmallStepSolver moves the sheet.
    int smallSteps;
    /// Substeps, since the WetCloth was made, whose small steps came to something not finite, so that the
    /// sheet stayed where it was, at rest. 0 but for forces or obstacles beyond all measure.
    int heldSubsteps;
};

/// The water of one soft body and what it does to it.
///
/// At the start of each of Bullet's substeps the sources bring their water; it dries, soaks in, wicks, runs
/// down and drips (see `Moisture::step`); then node masses (with the momentum that the water brought), link
/// stiffness in N/m and air forces are rewritten from it. A face on a solid body (btSoftBody::m_rcontacts,
/// m_nodeRigidContacts) does not dry, and nothing drips from a node that lies on one.
///
/// What this takes over of the body, and gives back when it ends:
/// - node masses. Pins (inverse mass 0) stay pins, and may come and go while running;
/// - link constants, and the rest lengths against a setMass in flight, after which Bullet would reset them;
/// - the order of the links: hard links in mesh order blow up, so they come in colours meanwhile. Do not reorder them
///   (randomizeConstraints) while attached;
/// - the aero model: kDG and kLF are 0 meanwhile;
/// - the collision shape, replaced by one that knows when the body is deleted. Ask getCollisionShape() for it
///   each time; its margin and user data carry over;
/// - in the deformable world, collision flags of SDF_RS, which Bullet gives new bodies but does not serve
///   there: they are SDF_RD | SDF_RDN meanwhile.
///
/// - contacts with solids and with other sheets, for their friction and cling: hardness (kCHR, kKHR) and, with the stock
///   solver, Bullet's own friction play no part;
/// - the world's post-tick callback, from the start of a substep to that moment, when it calls the application's.
///
/// Everything else, user pointer and tags, iterations and damping, stays the application's.
///
/// A SmallStepSolver gives links and bending their stiffness in one substep a frame. How stiff links are with the
/// stock solver: with piterations = 1 (and viterations = diterations = 0), a substep dt, and w the sum
/// of a link's inverse masses, the layer writes m_c0 = max(w, w/2 + 1 / (k dt^2)), a variant of XPBD (Macklin
/// et al. 2016) that is right at the end of the sweep. Up to `stepBound` a link has its stiffness of k N/m;
/// beyond it acts softer, by about w dt^2 / 2 beside 1 / k. With n > 1 sweeps m_c0 = w / (1 - (1 + w k
/// dt^2)^(-1/n)); that helps less than n times the substeps. m_kLST plays no part. In single precision,
/// within a few metres of the origin, substeps below about 1/2000 s lose gravity to rounding; where
/// `stepBound` is shorter, use double-precision Bullet or a coarser grid, or live with softer links.
///
/// In the deformable world the same calls do the same by a btDeformableLagrangianForce of the layer's: links
/// and bending have their stiffness in any substep that is allowed, and link constants and iterations play no
/// part. Gravity is there the application's btDeformableGravityForce, for this body as for any other, and
/// does not come by itself. Of m_cfg that world heeds kDF, kKHR, kCHR and, in explicit steps, drag (the share
/// of velocity lost in a substep), and neither kDP nor timescale. Explicit steps (its default) must not be
/// longer than `stepBound`, and are refused if they are. Implicit ones (setImplicit and setUseProjection, both) may
/// be as long as 1/60 s for a sheet that hangs in still air and 1/240 s for one in wind or that touches something. In single precision
/// Bullet's solver stops early, and an implicit substep dt loses up to some 1e-3 k dt^2 / m of the momentum of
/// a blow, such as a big drop, to a node of mass m.
///
/// The layer, the body and the world may end in any order that Bullet itself allows: also after the body was
/// deleted, or the world, the layer only stops working. One layer a body, and one world a layer: in another
/// world than its own the body is not stepped by it. Many bodies a world. Not thread-safe: use it from the
/// thread that steps the world.
///
/// Node indices are those of the body; each call that takes one throws std::out_of_range for one that is not there.
class DRENCH_API WetCloth {
  public:
    /// Attaches to a body, in the world or not yet in it.
    /// @param world   that the body is or will be in: a btSoftRigidDynamicsWorld, btSoftMultiBodyDynamicsWorld
    ///                or btDeformableMultiBodyDynamicsWorld
    /// @param sheet   any soft body with faces and links: from `makeSheet`, CreatePatch, CreateFromTriMesh, your own
    /// @param fabric  its cloth; copied
    /// @throws std::invalid_argument, with the body as it was, for a world of another kind; a fabric or setting
    ///     out of range; a body without faces or links, with clusters or tetrahedra, with a node or link that
    ///     is not finite, a link of no length, a triangle of no area, two faces or links of the same nodes, or
    ///     with a WetCloth already; a voxel size of its world info, or a margin, larger than its mean link; a
    ///     plane shape in the world that its collision filters, once it has any, let it meet; material
    ///     coordinates that do not fit it.
    WetCloth(btDiscreteDynamicsWorld& world, btSoftBody& sheet, const Fabric& fabric,
             const SheetSettings& settings = {});
    ~WetCloth();
    WetCloth(const WetCloth&) = delete;
    WetCloth& operator=(const WetCloth&) = delete;

    /// The air around the sheet; change it as you like between steps. Wind does not wake a body that sleeps.
    /// All of the sheet dries alike: at the speed of the wind, on average over the sheet, against the cloth's mean
    /// velocity, over a length that is the root of its area.
    Air& air();
    const Air& air() const;  ///< The same, to read.

    /// Says what a solid is to this cloth: how its friction coefficients depend on the water of each node, and
    /// whether wet cloth clings to it. Of a solid that nothing is said of, the friction coefficient is that on
    /// a plate, times m_cfg.kDF x the solid's own friction over the fabric's dry one, so that dry cloth has
    /// Bullet's own; and wet cloth clings to it as to a plate.
    ///
    /// Friction is Coulomb's, for each node by its own water (see `frictionCoefficient`). Cling is cohesion (see
    /// `WetLaws::clingEnergy`): where wet cloth has touched it stays bonded, and is pulled back with energy / reach x
    /// area of the node, up to the reach of the bond, the root of a node's area (1 to 10 mm), where it breaks. So
    /// to peel a strip at a right angle takes energy x width, and cloth hangs from a ceiling as long as energy / reach
    /// exceeds its weight. A bond adds to what presses the faces together, and so to friction. Both act back on the solid.
    /// Other sheets with a WetCloth cling where both are wet; a soft body without one counts as wettable.
    /// A friction coefficient of Bullet's that is negative or no number counts as 0, one beyond 1000 as 1000.
    /// @param solid  by its address, which need not exist any more; where another takes its place in memory,
    ///               say so again
    void setSurface(const btCollisionObject& solid, SurfaceKind kind);
    /// The same for a surface of your own. @throws std::invalid_argument for a value out of range
    void setSurface(const btCollisionObject& solid, const Surface& surface);
    /// Forgets what was said of a solid.
    void clearSurface(const btCollisionObject& solid);

    /// Changes how fast water runs from the next substep on; see `SheetSettings::waterSpeed`.
    /// @throws std::invalid_argument for a value that is not from 0 to 1e5
    void setWaterSpeed(double speed);
    /// How much faster water runs than the body's own time, 1.
    double waterSpeed() const;

    /// Adds a source of water: one of those in sources.h and wet_contact.h, or your own. It works from the
    /// next substep on, in the account of its name; sources of the same name share it.
    /// @return the source where it is now, until it is removed; its settings may be changed there
    /// @throws what the source throws when its settings are off; it is then not added
    template <typename SourceType>
    SourceType& add(SourceType source) {
        return add(std::make_unique<SourceType>(std::move(source)));
    }
    /// The same for a source on the heap. @throws std::invalid_argument for none
    template <typename SourceType>
    SourceType& add(std::unique_ptr<SourceType> source) {
        SourceType* const stays = source.get();
        addSource(std::move(source));
        return *stays;
    }
    /// Removes and destroys a source; its account stays. @throws std::invalid_argument for one that is not here
    void remove(const Source& source);

    /// Brings water and takes it back at any time, in the account of that name, in the body's own time. Lives
    /// as long as the WetCloth.
    Supply& account(const std::string& name);

    /// Hands over the drops that fell since the last call, oldest first. At most the last 100,000 are kept.
    std::vector<Drop> takeDrops();

    /// Puts water on the faces of one node; it takes part from the next substep on, and wakes the body.
    /// @param mass      kg, 0 to 1e6
    /// @param velocity  of the water as it arrives, m/s; the node takes up its momentum
    /// @throws std::invalid_argument for a mass out of range, a velocity that is not finite, or a node without cloth.
    void addWater(int node, double mass, const btVector3& velocity);

    /// Puts water on the faces of one node that moves with the node. Otherwise as above.
    void addWater(int node, double mass);

    /// Puts the same water on every part of the cloth at once; it moves with the cloth. The source `Soak` is
    /// for chosen places, and takes its time.
    /// @param massPerArea  kg per m2 of cloth, 0 to 1000
    /// @throws std::invalid_argument for a value out of range.
    void soak(double massPerArea);

    /// The same, straight into the pores, as if they had had time to take it up; what they cannot hold is on the faces.
    void presoak(double massPerArea);

    /// Pore and film water of the whole sheet, kg.
    double waterMass() const;
    /// Mass of the dry cloth, kg.
    double dryMass() const;
    /// Cloth and water of one node, kg, also for a pinned one.
    double nodeMass(int node) const;
    /// Pore water of a node over its pore capacity, 0 to 1.
    double saturation(int node) const;
    /// Water of a node over its dry cloth, kg/kg.
    double content(int node) const;
    /// Diffuse colour of a node.
    Colour albedo(int node) const;
    /// Share of the light that passes the cloth at a node, 0 to 1; see `WetLaws::transmittance`.
    double transmittance(int node) const;
    /// How much of a node shines like water, 0 to 1; see `WetLaws::gloss`.
    double gloss(int node) const;
    /// What the sheet is made of.
    const Fabric& fabric() const;
    /// All stores of all nodes.
    const Moisture& moisture() const;
    /// What came and where it went.
    Ledger ledger() const;
    /// Material coordinates of each node, m; of a node on a seam, those in the first of its faces.
    const std::vector<Eigen::Vector2d>& materialCoordinates() const;

    /// Longest substep at which, with piterations = 1, every stretch and shear link has its stiffness, s of
    /// the body's own time: the smallest sqrt(2 / (w k)) over them, with water as it is now and no pins;
    /// infinite if there is none. The free corners of a grid set it; the rest of the sheet allows sqrt(2)
    /// more. In the deformable world's explicit steps instead the longest substep that does not blow up,
    /// wet or dry, in any pose and without pins, which is the longest that is allowed; it stays the same
    /// while the sheet dries. In its implicit ones, as of the last substep, infinite.
    double stepBound() const;

    /// All that the next steps depend on, of the body, its water and what it touches, at this moment. Not in it is what
    /// the application sets: fabric, air and wind, water speed, surfaces, the settings of sources, of the body (m_cfg,
    /// anchors, margin) and of the world; nor rigid bodies, nor drops that a FallingDrops has
    /// taken, which it can save itself. See
    /// docs/snapshots.md.
    /// @throws std::logic_error within a step, or while the body is not in its world; std::runtime_error for a sheet
    ///     that is not finite
    Snapshot snapshot() const;
    /// Goes back, or on, to such a moment. Where all settings are as they were, and solids where they were, the steps
    /// that follow are to the last bit those that followed then: also in another world or process where the body was
    /// built and its WetCloth made in the same way, with the same sources in the same order, by a library and Bullet
    /// of the same build. Pins come back as they were. What the sheet has touched is known by its place in the world's
    /// list of collision objects, so that has to be in the same order.
    /// @throws std::logic_error as above; std::runtime_error that says why the snapshot does not fit: another
    ///     precision, topology, size or fabric, kind of world, other sources, an object that is not there, or values
    ///     that no sheet has; and what a source of your own throws. All is then as before.
    void restore(const Snapshot& snapshot);

    /// Looks over all nodes, links and contacts. Once the body has ended, all is 0
    /// and `finite` is false.
    SheetHealth health() const;

    /// What the steps of this sheet have taken so far.
    StepTimes times() const;

    /// Does the layer's work for a substep of `dt` seconds that is about to begin. Only for `Stepping::byApplication`;
    /// otherwise the world calls it and its errors come out of stepSimulation: Bullet's step is then left undone, other
    /// sheets may have had theirs, and world.clearForces() is due before the next. The world's step also throws
    /// std::invalid_argument when a plane shape has come that the body can meet. Does nothing while the body is in no
    /// world or no longer exists.
    /// @throws std::logic_error with `Stepping::byWorld`; std::invalid_argument for a dt that is not positive
    ///     and finite, air or a source's setting out of range, and whatever a source of your own throws;
    ///     std::runtime_error if a position, velocity or force of the body, its timescale, the wind, also that of its
    ///     field, or the gravity is not finite, the gravity is over 1e4 m/s2, if its nodes, links or faces have changed in number,
    ///     or, in the deformable world, for explicit substeps beyond `stepBound` and implicit ones without
    ///     projection. The body is then as before the call; of the sources, those before the one that threw have
    ///     given.
    void preSubstep(btScalar dt);

  private:
    friend class FallingDrops;
    friend class Touch;
    void addSource(std::unique_ptr<Source> source);

    struct DRENCH_LOCAL Layer;
    std::shared_ptr<Layer> layer_;  // shared with none but those who watch whether it still is
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
