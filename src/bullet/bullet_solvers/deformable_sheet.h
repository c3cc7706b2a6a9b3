// What a layer does for a sheet in Bullet's deformable world, where link constants and nodal forces count for
// nothing.
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
    // @param mechanics  in the layer's order of links; outlives this
    // @param dryMasses  of the nodes, kg; of a node without cloth it is that of the body
    // @param stiffestStretch, stiffestBending  the largest that water makes of 1
    DeformableSheet(const btDiscreteDynamicsWorld& world, const btSoftBody& body,
                    const SheetMechanics& mechanics, std::vector<double> dryMasses, double stiffestStretch,
                    double stiffestBending);

    // Becomes that of the same cloth, cut. @pre the body is in the world. Otherwise as in the constructor.
    void recut(const btDiscreteDynamicsWorld& world, const btSoftBody& body, const SheetMechanics& mechanics,
               std::vector<double> dryMasses, double stiffestStretch, double stiffestBending);

    // Longest substep that the explicit world holds out, wet or dry, s; in the implicit world, as of the last
    // substep, infinite.
    double stepBound() const;

    // @throws std::runtime_error for a substep beyond the bound, or a world that is implicit without projection
    void check(const btDiscreteDynamicsWorld& world, double dt);

    // Makes the body ready for the step to come: the force in the solver's list, stiffness, anchors and
    // collision flags as they should be. @pre the body is in the world and has its masses
    void write(btSoftBody& body);

    // Ends all that. @pre the body exists and has its own masses again
    void restore(btSoftBody& body);

    // The end of one whose world may be gone. @param body  none if it is gone as well
    void end(const btSoftBody* body);

  private:
    std::unique_ptr<WetSpringForce> force_;
    double explicitBound_;  // s
    DeformableMode mode_;
    bool collisionsReplaced_ = false;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
