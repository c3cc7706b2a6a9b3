// How a sheet holds on to what it touches: friction and cling of each node, by its water and the surface.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

#include <array>
#include <map>
#include <vector>

#include "drench/cloth_mesh.h"
#include "drench/config.h"
#include "drench/fabric.h"
#include "drench/moisture.h"
#include "drench/surface.h"
#include "drench/wet_laws.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

class BulletPass;

// Cling is cohesion: where wet cloth has touched a surface it stays bonded to it. A bond pulls its node back
// with a force of up to energy / reach x area, as far as `reach`, where it breaks. So to peel takes the
// energy, whatever the reach is. The reach is the distance of neighbouring nodes: rows of nodes then come off one
// after the other at an even force; a much shorter one would hold each row with a large force over a small way,
// which a hanging weight could not overcome.
class Friction {
  public:
    Friction(const Fabric& fabric, const ClothMesh& mesh);

    // Says what a solid is to this cloth. @throws std::invalid_argument for a surface out of range
    void setSurface(const btCollisionObject& solid, const Surface& surface);
    void setSurface(const btCollisionObject& solid, SurfaceKind kind) { surfaces_[&solid] = ofKind(kind); }
    // Back to what holds for any solid: see `surfaceAt`.
    void clearSurface(const btCollisionObject& solid) { surfaces_.erase(&solid); }

    // The surface of a solid: the one that was set; else a wettable plate, with all friction coefficients
    // times kDF x the solid's own friction over the dry one.
    // @param kDF  the sheet's m_cfg.kDF
    Surface surfaceAt(const btCollisionObject& solid, btScalar kDF) const;

    // Says by what water to answer from now on; nodes are looked at when they are asked for, as few touch anything.
    // @param laws, moisture  stay where they are
    void evaluate(const WetLaws& laws, const Moisture& moisture) {
        laws_ = &laws;
        moisture_ = &moisture;
    }

    // @pre `evaluate`
    // Friction coefficient of a node on a surface, 1.
    double friction(const Surface& surface, std::size_t node) const {
        return frictionCoefficient(surface, moisture_->saturation(node), moisture_->filmThickness(node));
    }
    // Force of the bond of a node, per wettability, N.
    double adhesion(std::size_t node) const { return adhesionTraction(node) * areas_[node]; }
    // The same on a surface, N.
    double adhesion(const Surface& surface, std::size_t node) const {
        return surface.wettability * adhesion(node);
    }
    // Where bonds break, m.
    double reach() const { return reach_; }
    // Whether the cloth would cling if it were wet.
    bool canAdhere() const { return canAdhere_; }

    // By how much water changes the friction of a node with other cloth, 1: as on a plate.
    double frictionRatio(std::size_t node) const;
    // Energy of the bond of a node per reach, N/m2.
    double adhesionTraction(std::size_t node) const;
    double area(std::size_t node) const { return areas_[node]; }

    // Takes over what has been said of solids, and the bonds, of the cloth that this is cut from.
    void takeOver(const Friction& other);

    // What each node is bonded to, by its address alone; none for no bond. Cloth has two faces.
    std::vector<const btCollisionObject*> adheresTo;       // a solid
    std::vector<const btCollisionObject*> adheresToCloth;  // another soft body

  private:
    friend class BulletPass;
    void state(BulletPass& pass);

    const Surface& ofKind(SurfaceKind kind) const { return kinds_[static_cast<std::size_t>(kind)]; }

    std::array<Surface, 3> kinds_;  // in the order of SurfaceKind
    double reach_;                  // m
    std::vector<double> areas_;
    std::map<const btCollisionObject*, Surface> surfaces_;
    bool canAdhere_;
    const WetLaws* laws_ = nullptr;
    const Moisture* moisture_ = nullptr;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
