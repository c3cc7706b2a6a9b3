// Wet friction and adhesion of sheets in Bullet's deformable world.
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

// Gives the contacts that Bullet has found the friction coefficient of each node, before Bullet solves them,
// because Bullet's friction is Coulomb's there. Adhesion pulls a node to the surface. If the node touches,
// the contact responds with a larger normal force and so with more friction; if not, the node is pulled no
// farther than to the surface. In implicit steps adhesion at a distance from the surface has no friction. On
// triangle meshes adhesion acts only in contact; on links of a btMultiBody there is none.
class DeformableContacts {
  public:
    // @param implicit  whether the world integrates implicitly
    // @pre the body is in the world; velocities are those at the end of the substep without contacts
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
    std::vector<const btCollisionObject*> adheresTo_;  // adhesive bonds of each node as they are formed
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
