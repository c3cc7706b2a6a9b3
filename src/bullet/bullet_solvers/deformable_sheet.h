// Handles a sheet in Bullet's deformable world, where link constants and nodal forces have no effect.
#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletSoftBody/btSoftBody.h>

#include <memory>
#include <vector>

#include "bullet/bullet_solvers/wet_spring_force.h"
#include "bullet/sheet/sheet_mechanics.h"
#include "bullet/world/soft_world.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

class DeformableSheet {
  public:
    // @param mechanics  with links in the layer's order; must outlive this
    // @param dryMasses  of the nodes, kg; for a node without cloth that of the body
    // @param stiffestStretch, stiffestBending  largest factor by which water increases the stiffness, at
    //     least 1
    DeformableSheet(const btDiscreteDynamicsWorld& world, const btSoftBody& body,
                    const SheetMechanics& mechanics, std::vector<double> dryMasses, double stiffestStretch,
                    double stiffestBending);

    // Adapts to the cloth after a cut. @pre the body is in the world. Otherwise as the constructor.
    void recut(const btDiscreteDynamicsWorld& world, const btSoftBody& body, const SheetMechanics& mechanics,
               std::vector<double> dryMasses, double stiffestStretch, double stiffestBending);

    // Longest stable substep in the explicit world, wet or dry, s; infinite if the last substep was implicit.
    double stepBound() const;

    // @throws std::runtime_error for a substep above the bound, or an implicit world without projection
    void check(const btDiscreteDynamicsWorld& world, double dt);

    // Prepares the body for the next step: the force in the solver's list, stiffness, anchors and collision
    // flags. @pre the body is in the world and has its masses
    void write(btSoftBody& body);

    // Undoes that. @pre the body exists and has its own masses again
    void restore(btSoftBody& body);

    // Detaches when the world may have been destroyed. @param body  null if it was destroyed, too
    void end(const btSoftBody* body);

  private:
    std::unique_ptr<WetSpringForce> force_;
    double explicitBound_;  // s
    DeformableMode mode_;
    bool collisionsReplaced_ = false;
    bool softCollisionsReplaced_ = false;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
