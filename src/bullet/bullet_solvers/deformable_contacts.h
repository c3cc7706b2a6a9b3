// Wet friction and cling of sheets in Bullet's deformable world.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/bullet_solvers/contact_order.h"
#include "bullet/bullet_solvers/met_solids.h"
#include "bullet/contact/friction.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Gives the contacts that Bullet has found, before it solves them, the friction coefficient of each node, as
// Bullet's friction is Coulomb's there. A bond pulls its node to the surface by what it has: where the node
// touches, the contact pushes back, with more friction; where it does not, no farther than to the surface.
// In implicit steps bonds away from the surface have no friction. With triangle meshes there is no bond outside of
// contact, with links of a btMultiBody none at all.
class DeformableContacts {
  public:
    // @param implicit  whether the world is
    // @pre the body is in the world; velocities are those that the substep would end with without contacts
    void rewrite(const btCollisionWorld& world, btSoftBody& body, Friction& sheetFriction, btScalar substep,
                 bool implicit);

  private:
    struct Substep {
        btSoftBody& body;
        const Friction& sheetFriction;
        btScalar time;  // s
        btScalar margin;
        bool implicit;
    };
    void rewrite(btSoftBody::DeformableNodeRigidContact& contact, const Substep& now);
    void rewrite(btSoftBody::DeformableFaceRigidContact& contact, const Substep& now);
    void hold(std::size_t n, const btCollisionObject* solid, const Substep& now);

    ContactOrder order_;
    MetSolids met_;
    std::vector<const btCollisionObject*> adheresTo_;  // of each node, as they come to be
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
