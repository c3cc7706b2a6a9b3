// Friction and adhesion of each node of a sheet, from its water and from the surface that it touches.
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

// Adhesion is modelled as a cohesive bond that forms where wet cloth has touched a surface. It pulls the node
// back with a force of up to energy / reach x area, and breaks at a distance of `reach`. So peeling takes the
// energy, independent of the reach. The reach is the distance of neighbouring nodes: rows of nodes then come
// off one after the other at a constant force. A much shorter reach would hold each row with a large force
// over a short distance, which a hanging weight could not overcome.
class Friction {
  public:
    Friction(const Fabric& fabric, const ClothMesh& mesh);

    // Sets the surface of a solid for this cloth. @throws std::invalid_argument for a surface out of range
    void setSurface(const btCollisionObject& solid, const Surface& surface);
    void setSurface(const btCollisionObject& solid, SurfaceKind kind) { surfaces_[&solid] = ofKind(kind); }
    // Restores the default surface; see `surfaceAt`.
    void clearSurface(const btCollisionObject& solid) { surfaces_.erase(&solid); }

    // The surface of a solid: the one that was set; otherwise a wettable plate, with all friction
    // coefficients scaled by kDF x the solid's friction / dry friction.
    // @param kDF  the sheet's m_cfg.kDF
    Surface surfaceAt(const btCollisionObject& solid, btScalar kDF) const;

    // Sets the water that the functions below use. Values are computed only on request, because few nodes are
    // in contact.
    // @param laws, moisture  must outlive this
    void evaluate(const WetLaws& laws, const Moisture& moisture) {
        laws_ = &laws;
        moisture_ = &moisture;
    }

    // @pre `evaluate`
    // Friction coefficient of a node on a surface, dimensionless.
    double friction(const Surface& surface, std::size_t node) const {
        return frictionCoefficient(surface, moisture_->saturation(node), moisture_->filmThickness(node));
    }
    // Adhesive force of a node at a wettability of 1, N.
    double adhesion(std::size_t node) const { return adhesionTraction(node) * areas_[node]; }
    // The same on a surface, N.
    double adhesion(const Surface& surface, std::size_t node) const {
        return surface.wettability * adhesion(node);
    }
    // Distance at which adhesive bonds break, m.
    double reach() const { return reach_; }
    // Whether the cloth would adhere if it were wet.
    bool canAdhere() const { return canAdhere_; }

    // Factor by which water changes the friction of a node on other cloth, dimensionless; the same as on a
    // plate.
    double frictionRatio(std::size_t node) const;
    // Adhesion energy of a node over the reach, N/m2.
    double adhesionTraction(std::size_t node) const;
    double area(std::size_t node) const { return areas_[node]; }

    // Takes over the surfaces of solids and the adhesive bonds from the cloth before a cut.
    void takeOver(const Friction& other);

    // What each node adheres to, by address only; null for nothing. There are two lists, because cloth has
    // two faces.
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
