// The layer: puts water into a btSoftBody and lets it show.
#pragma once

#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "drench/air.h"
#include "drench/fabric.h"
#include "drench/ledger.h"
#include "drench/moisture.h"
#include "drench/precision.h"
#include "drench/wet_laws.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// Who calls `WetCloth::preSubstep`.
enum class Stepping {
    byWorld,  ///< the world, through its pre-tick callback; the application's own callback runs before it
    byApplication  ///< the application, at the start of each substep; the world's callback stays untouched
};

/// Settings of one sheet in one world.
struct SheetSettings {
    /// Material coordinates (u along the warp, v along the weft) of each node, m. Empty: the sheet as it lies
    /// when attached, flattened onto its best plane, with the warp along the body's first link.
    std::vector<Eigen::Vector2d> materialCoordinates;

    /// How much faster water runs than mechanics, 1; 0 to 1e5. Default 1.
    double waterSpeed = 1;

    /// Default: by the world.
    Stepping stepping = Stepping::byWorld;
};

/// The water of one soft body and what it does to it.
///
/// At the start of each of Bullet's substeps: film goes into the pores, then node masses (with the momentum
/// that the water brought), link stiffness in N/m and air forces are rewritten from the water. What this
/// takes over, and gives back when it ends: node masses, rest lengths, link constants, the order of the links
/// (hard links in mesh order blow up, so they come in colours meanwhile), and the aero model (kDG and kLF are
/// 0 meanwhile). Pins (inverse mass 0) stay pins and may come and go while running. Everything else of the
/// body, its user pointer and tags, iterations, damping and contacts, stays the application's.
///
/// The stock solver takes stiffness as a compliance in the manner of XPBD (Macklin et al. 2016): for one
/// sweep in a substep dt and w the sum of a link's inverse masses, m_c0 = max(w, w/2 + 1 / (k dt^2)). Use
/// m_cfg.piterations = 1 and substeps up to `stepBound`; with longer ones links are too soft, and more sweeps
/// do not make up for it. In single precision substeps below about 1/2000 s lose gravity to rounding.
///
/// The layer, the body and the world may end in any order. One layer a body; many bodies a world. Not
/// thread-safe: use it from the thread that steps the world.
class WetCloth {
  public:
    /// Attaches to a body, in the world or not yet in it.
    /// @param world   that the body is or will be in
    /// @param sheet   any soft body with faces and links: from `makeSheet`, CreatePatch, CreateFromTriMesh,
    /// your own
    /// @param fabric  its cloth; copied
    /// @throws std::invalid_argument, with the body as it was, for a fabric or setting out of range; a body
    /// without
    ///         faces or with clusters, tetrahedra, a node or link that is not finite, a link of no length, a
    ///         triangle of no area, or a WetCloth already; a voxel size or margin larger than the sheet's
    ///         mean link; a plane shape in the world that the sheet can meet; material coordinates that do
    ///         not fit the body.
    WetCloth(btSoftRigidDynamicsWorld& world, btSoftBody& sheet, const Fabric& fabric,
             const SheetSettings& settings = {});
    ~WetCloth();
    WetCloth(const WetCloth&) = delete;
    WetCloth& operator=(const WetCloth&) = delete;

    /// The air around the sheet; change it as you like between steps.
    Air& air();
    const Air& air() const;

    /// Puts water on the faces of one node; it takes part from the next substep on.
    /// @param mass      kg, at least 0
    /// @param velocity  of the water as it arrives, m/s; the node takes up its momentum
    /// @throws as `Moisture::addFilm`; std::invalid_argument for a velocity that is not finite.
    void addWater(int node, double mass, const btVector3& velocity);

    /// Puts water on the faces of one node, arriving with the node's own velocity.
    void addWater(int node, double mass);

    /// Puts the same water on every part of the cloth, arriving with the cloth's own velocity.
    /// @param massPerArea  kg per m2 of cloth, at least 0
    void soak(double massPerArea);

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
    /// How much of a node shines like water, 0 to 1; see `WetLaws::gloss`.
    double gloss(int node) const;
    /// All stores of all nodes.
    const Moisture& moisture() const;
    /// What came and where it went.
    Ledger ledger() const;
    /// Material coordinates of each node, m.
    const std::vector<Eigen::Vector2d>& materialCoordinates() const;

    /// Longest substep at which, with piterations = 1, the stretch and shear links show their stiffness, s:
    /// the smallest sqrt(2 / (w k)) over them, as they are now. With longer ones they act softer, by about w
    /// dt^2 / 2 beside 1 / k.
    double stepBound() const;

    /// Does the layer's work for a substep of `dt` seconds that is about to begin. Only for
    /// `Stepping::byApplication`; otherwise the world calls it. Nothing happens while the body is in no world
    /// or no longer exists.
    /// @throws std::invalid_argument for a dt that is not positive and finite; std::runtime_error if a
    /// position or
    ///         velocity of the body, or the wind, is not finite, or if its nodes, links or faces have changed
    ///         in number. Bullet is then spared the step's changes.
    void preSubstep(btScalar dt);

  private:
    class Layer;
    std::unique_ptr<Layer> layer_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
