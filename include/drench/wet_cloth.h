// Adds water to a btSoftBody, and updates its mechanics and its appearance accordingly.
#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "drench/air.h"
#include "drench/config.h"
#include "drench/fabric.h"
#include "drench/health.h"
#include "drench/moisture.h"
#include "drench/snapshot.h"
#include "drench/source.h"
#include "drench/surface.h"
#include "drench/wet_laws.h"

namespace drench {

/// Drops that fell from one node at one time.
struct Drop {
    Eigen::Vector3d position;  ///< where they fell from, m
    Eigen::Vector3d velocity;  ///< of the cloth there, m/s
    double mass;               ///< of each drop, kg
    std::int64_t count;        ///< number of drops; above 1 where much water drips
    double time;               ///< of the body, since its WetCloth was made, s
    int node;                  ///< index of the node
};

inline namespace DRENCH_BULLET_NAMESPACE {

/// Who calls `WetCloth::preSubstep`.
enum class Stepping {
    /// The world, through its pre-tick callback. Set a pre-tick callback of your own before the world's first WetCloth
    /// is made; it then runs first in each substep. One that is set later replaces Drench's, and the WetCloths of the
    /// world stop until another one is made.
    byWorld,
    /// The application, at the start of each substep. The world's pre-tick callback is not used.
    byApplication
};

/// Settings of one sheet in one world.
struct SheetSettings {
    /// Material coordinates (u along the warp, v along the weft) of each node, m. Empty, the default: the present
    /// positions, which must be nearly flat, projected onto their best-fit plane, with the warp along the body's first
    /// link. To attach again to a sheet that hangs in folds, pass the `materialCoordinates()` of the previous WetCloth.
    std::vector<Eigen::Vector2d> materialCoordinates;

    /// Alternative for cloth with seams, such as a sleeve: material coordinates of the three corners of each face, m.
    /// Neighbouring faces must agree only on the length of their common edge. Empty, the default: not used. See
    /// `wrappedCoordinates` and `texturedCoordinates`.
    std::vector<std::array<Eigen::Vector2d, 3>> faceCoordinates;

    /// Ratio of water time to the body's time, dimensionless; 0 to 1e5; default 1. At 60 an hour of drying takes a
    /// minute. Sources run in water time; if the ratio is above 1, the momentum of arriving water is divided by it.
    double waterSpeed = 1;

    /// Who calls `WetCloth::preSubstep`; default: the world.
    Stepping stepping = Stepping::byWorld;

    /// What to do about problems while the world runs; default: repair and report them.
    OnTrouble onTrouble = OnTrouble::carryOn;

    /// Whether the sheet is meant to have another gravity than the world. A sheet and its water have the gravity with
    /// which Bullet moves the body: in the deformable world that of its btDeformableGravityForce, times
    /// setGravityFactor; in other worlds that of the body's world info. If false, the default, that gravity is compared
    /// with world.setGravity, and a difference of more than 5 % is `Trouble::gravityPlaces`, unless it is zero. If the
    /// world info still has Bullet's (0, -10, 0), or there is no such force, the world's is used instead (without a
    /// force the body does not fall, but its water does). If true, the body's gravity is used in any case.
    bool ownGravity = false;

    /// Whether a size or gravity that looks like another unit is meant: then it is no `Trouble::units`. Default false.
    bool unusualScale = false;

    /// Whether the sheet may be in several pieces from the start, such as strips of one body. Default: false; several
    /// pieces are then reported as `Trouble::pieces`.
    bool mayBeInPieces = false;

    /// Whether a SmallStepSolver keeps the layers of the sheet apart where it is folded; default true. Layers that touch
    /// wick into each other (see `Moisture::joinLayers`); faces that are covered do not dry, drip or catch rain. With the
    /// stock solver and in the deformable world nothing keeps them apart: a sheet passes through itself, which is reported
    /// as `Trouble::crossing` unless this is false.
    bool meetsItself = true;

    /// Whether a SmallStepSolver keeps the sheet apart from all other sheets of which this is true; default true. They
    /// pass water as layers of one sheet do, in the ledger account "touch" of both, at the lower of both water speeds. Other
    /// soft bodies, and all sheets without such a solver, need fCollision::VF_SS in both bodies' m_cfg.collisions.
    bool meetsSheets = true;
};

/// Adds water to one btSoftBody: before each of Bullet's substeps sources add their water, the water moves (see
/// `Moisture::step`), and node masses, link stiffness and air forces are computed from it. docs/wet-cloth.md lists the
/// body fields that change while it is attached and are restored on destruction. Body, world and WetCloth may be
/// destroyed in any order that Bullet allows; without its body or world a WetCloth does nothing. A body has at most one
/// WetCloth, is simulated only in its world, and may be cut, refined or extended meanwhile (docs/health.md). Use a
/// WetCloth only in the thread that steps its world. Node indices are those of the body at the last substep; functions
/// with a node index throw std::out_of_range for one that does not exist.
class DRENCH_API WetCloth {
  public:
    /// @name Attaching
    /// @{

    /// Attaches to a body, which need not be in the world yet.
    /// @param world   a btSoftRigidDynamicsWorld, btSoftMultiBodyDynamicsWorld or btDeformableMultiBodyDynamicsWorld
    /// @param sheet   a soft body with faces and links: from `makeSheet`, CreatePatch, CreateFromTriMesh or your own
    /// @param fabric  fabric of the cloth; copied
    /// @throws std::invalid_argument, with the body unchanged, for
    ///     - a world of another kind, or a fabric or setting out of range;
    ///     - a body without faces or links, with clusters or tetrahedra, with a node or link that is not finite, a link
    ///       of length 0, a triangle of area 0, duplicate faces or links, or a WetCloth already;
    ///     - a margin, or a voxel size of the world info, larger than the mean link;
    ///     - a plane shape in the world that the body's collision filters let it collide with;
    ///     - material coordinates that do not fit the body
    /// @throws std::runtime_error for a sheet in several pieces with OnTrouble::throwError; see `Trouble::pieces`
    WetCloth(btDiscreteDynamicsWorld& world, btSoftBody& sheet, const Fabric& fabric,
             const SheetSettings& settings = {});
    /// Detaches, and restores the body.
    ~WetCloth();
    WetCloth(const WetCloth&) = delete;
    WetCloth& operator=(const WetCloth&) = delete;

    /// @}
    /// @name Surroundings
    /// @{

    /// The air around the sheet; may be changed between steps. A change of the wind does not wake a sleeping body. The
    /// whole sheet dries at one rate: that of the mean speed of the wind relative to the mean velocity of the cloth,
    /// over a length that is the square root of the sheet's area.
    Air& air();
    const Air& air() const;  ///< The same, to read.

    /// Sets the kind of surface that a solid has for this cloth: friction coefficients as functions of the water, and
    /// adhesion. By default a solid is a plate, with all friction coefficients scaled by m_cfg.kDF x the solid's
    /// friction / `Fabric::plateFrictionDry`, so that the friction of dry cloth is Bullet's.
    ///
    /// Friction is Coulomb's, for each node by its own water (see `frictionCoefficient`). A friction coefficient of
    /// Bullet's that is negative or NaN counts as 0, one above 1000 as 1000.
    ///
    /// Adhesion (see `WetLaws::clingEnergy`) acts on a node of wet cloth once it has touched a surface: an adhesive
    /// bond pulls it back with a force of energy x area / reach, and breaks beyond its reach, the square root of the
    /// node's area, 1 to 10 mm. So the force to peel off a strip at a right angle is energy x width, and cloth hangs
    /// from a ceiling while energy / reach exceeds its weight per area. Adhesion adds to the normal force, and so to
    /// friction. The solid gets the opposite forces. Sheets that have a WetCloth adhere to each other where both are
    /// wet; a soft body without one counts as wettable.
    /// @param solid  known by its address; it may be destroyed. Call again if another object gets the same address
    void setSurface(const btCollisionObject& solid, SurfaceKind kind);
    /// The same for a surface of your own. @throws std::invalid_argument for a value out of range
    void setSurface(const btCollisionObject& solid, const Surface& surface);
    /// Makes the surface of a solid the default again.
    void clearSurface(const btCollisionObject& solid);

    /// Changes `SheetSettings::waterSpeed`, from the next substep on.
    /// @throws std::invalid_argument for a value below 0 or above 1e5
    void setWaterSpeed(double speed);
    /// Ratio of water time to the body's time, dimensionless.
    double waterSpeed() const;

    /// @}
    /// @name Adding and taking water
    /// @{

    /// Adds a source: one from sources.h or wet_contact.h, or your own. It takes effect from the next substep on.
    /// Sources of the same name share an account.
    /// @return the source, valid until it is removed; its settings may be changed there
    /// @throws what the source throws if its settings are invalid; it is then not added
    template <typename SourceType>
    SourceType& add(SourceType source) {
        return add(std::make_unique<SourceType>(std::move(source)));
    }
    /// The same for a source on the heap. @throws std::invalid_argument for a null pointer
    template <typename SourceType>
    SourceType& add(std::unique_ptr<SourceType> source) {
        SourceType* const stays = source.get();
        addSource(std::move(source));
        return *stays;
    }
    /// Removes and destroys a source; its account stays.
    /// @throws std::invalid_argument for a source that was not added here
    void remove(const Source& source);

    /// Adds and takes water directly, at any time and in the body's time, in the account of that name. The reference is
    /// valid as long as the WetCloth exists.
    Supply& account(const std::string& name);

    /// Adds film water to one node, from the next substep on, and wakes the body.
    /// @param mass      kg; 0 to 1e6
    /// @param velocity  of the water as it arrives, m/s; the node takes up its momentum
    /// @throws std::invalid_argument for a mass out of range, a velocity that is not finite, or a node without area
    void addWater(int node, double mass, const btVector3& velocity);

    /// The same for water that moves with the node.
    void addWater(int node, double mass);

    /// Adds film water to all nodes at once; it moves with the cloth. The source `TimedSoak` does so over a time, or on
    /// chosen nodes.
    /// @param massPerArea  kg per m2 of cloth; 0 to 1000
    /// @throws std::invalid_argument for a value out of range
    void soakFilm(double massPerArea);

    /// Adds pore water to all nodes at once; what the pores cannot hold becomes film. Otherwise as `soakFilm`.
    void soakPores(double massPerArea);

    /// Returns the drops that fell since the last call, oldest first; at most the last 100,000.
    std::vector<Drop> takeDrops();

    /// @}
    /// @name Reading the water
    /// @{

    /// Pore and film water of the whole sheet, kg.
    double waterMass() const;
    /// Mass of the dry cloth, kg.
    double dryMass() const;
    /// Mass of cloth and water of one node, kg; also for pinned nodes.
    double nodeMass(int node) const;
    /// Pore water of a node over its pore capacity, 0 to 1.
    double saturation(int node) const;
    /// Moisture content of a node: kg of water, in pores and film, per kg of dry cloth.
    double moistureContent(int node) const;
    /// Diffuse colour of a node; see `WetLaws::albedo`.
    Colour albedo(int node) const;
    /// Fraction of light that the cloth transmits at a node, 0 to 1; see `WetLaws::transmittance`.
    double transmittance(int node) const;
    /// Fraction of a node that is glossy like water, 0 to 1; see `WetLaws::gloss`.
    double gloss(int node) const;
    /// The fabric given to the constructor.
    const Fabric& fabric() const;
    /// Pore and film water of all nodes.
    const Moisture& moisture() const;
    /// Water balance since the WetCloth was made.
    Ledger ledger() const;
    /// Material coordinates of each node, m; for a node on a seam those in the first of its faces.
    const std::vector<Eigen::Vector2d>& materialCoordinates() const;

    /// @}
    /// @name Stepping and diagnostics
    /// @{

    /// Longest useful substep, s of the body's time, at the present water:
    /// - with the stock solver and piterations = 1, the longest at which every stretch and shear link has its
    ///   stiffness: the smallest sqrt(2 / (w k)) of all links, w the sum of the inverse masses of the unpinned
    ///   nodes, k the stiffness; infinite without links. On a grid the free corners have the smallest; the rest of the
    ///   sheet allows sqrt(2) times as much;
    /// - in the deformable world with explicit steps, the longest that is stable, wet or dry, in any pose and with any
    ///   pins. Longer substeps are refused. It does not change while the sheet dries;
    /// - in the deformable world with implicit steps (as of the last substep), infinite.
    double stepBound() const;

    /// Computes diagnostics of all nodes, links and contacts. Once the body has been destroyed, all values are 0 and
    /// `finite` is false.
    /// @param mostCrossings  number of crossings after which their count ends, 0 to 1e6; default 0: they are not
    ///     counted, which takes longer than all the rest. The count looks at no more than 500 pairs of faces for each
    ///     face of the sheet
    /// @throws std::invalid_argument for a number out of range
    SheetHealth health(int mostCrossings = 0) const;

    /// Problems since the WetCloth was made or `clearTroubles` was called: one report per kind, in order of first
    /// occurrence. docs/health.md lists all kinds.
    const std::vector<TroubleReport>& troubles() const;
    /// Removes all reports.
    void clearTroubles();

    /// Computing times of the steps so far.
    StepTimes times() const;

    /// Says that the application has put the sheet, with its anchors and the solids around it, to another place since the
    /// last step, for instance at a respawn or a shift of the origin. What has moved in between then counts as a jump, not
    /// as motion: in the next substep the SmallStepSolver takes pins, kinematic bodies, static bodies and ghosts where they
    /// are now, at rest. Velocities of nodes and dynamic bodies are kept. Calls are not needed where all nodes were moved,
    /// as btSoftBody::transform does, nor where a solid moves as far and fast as described in `SmallStepSolver`.
    /// Does nothing with other solvers.
    void jumped();

    /// Prepares the substep that is about to begin: sources, water, node masses, stiffness and forces. Only for
    /// `Stepping::byApplication`; otherwise the world calls it, and exceptions leave stepSimulation: Bullet then skips
    /// the substep, other sheets may already have been prepared for it, and world.clearForces() must be called before
    /// the next step. The world's step also throws std::invalid_argument if a plane shape was added that the body can
    /// collide with. Does nothing while the body is in no world, or destroyed.
    /// @param dt  duration of the substep, s; above 0 and finite
    /// @throws std::logic_error with `Stepping::byWorld`; std::invalid_argument for a dt out of range; in the
    ///     deformable world std::runtime_error for explicit substeps longer than `stepBound` and for implicit ones
    ///     without projection. With OnTrouble::throwError also std::runtime_error for each `Trouble`, and for
    ///     `Trouble::air` and `Trouble::source` the exception itself. The body is then unchanged, but the sources
    ///     before the one that threw have added their water
    void preSubstep(btScalar dt);

    /// @}
    /// @name Snapshots
    /// @{

    /// The complete state of the body, its water and its contacts: all that the next steps depend on except what the
    /// application sets (fabric, air, water speed, surfaces, settings of sources, body and world), rigid bodies, and
    /// drops that a FallingDrops has taken. docs/snapshots.md says more.
    /// @throws std::logic_error within a step, or while the body is not in its world; std::runtime_error for a sheet
    ///     that is not finite
    Snapshot snapshot() const;
    /// Sets the state to that of a snapshot, pins included. If all settings and solids are as they were, the steps that
    /// follow are bit-identical to those that followed the snapshot; also in another world or process, if the body and
    /// its WetCloth were made in the same way, with the same sources in the same order, by the same build of Drench and
    /// Bullet. Objects that the sheet touches are identified by their index in the world's list of collision objects,
    /// so that order must be the same.
    /// @throws std::logic_error as `snapshot`; std::runtime_error, with the reason, for a snapshot that does not fit:
    ///     another precision, topology, size or fabric, another kind of world, other sources, an object that does not
    ///     exist, or invalid values; and what a source of your own throws. Nothing is then changed
    void restore(const Snapshot& snapshot);

    /// @}

  private:
    friend class FallingDrops;
    friend class Touch;
    void addSource(std::unique_ptr<Source> source);

    struct DRENCH_LOCAL Layer;
    std::shared_ptr<Layer> layer_;  // shared, so that others can watch with a weak_ptr whether it exists
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
