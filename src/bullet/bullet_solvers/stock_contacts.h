// Wet friction and adhesion of sheets that Bullet's stock solver moves in a soft-rigid world.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/bullet_solvers/contact_order.h"
#include "bullet/bullet_solvers/met_solids.h"
#include "bullet/contact/friction.h"
#include "bullet/contact/solids.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

class BulletPass;

// Rewrites the contacts that Bullet has found, before it solves them, so that each only stops the motion of
// its node into the solid. Friction and adhesion are applied here, immediately. Because Bullet solves links
// after contacts, links pull nodes into solids and along them; here those nodes are moved out again, and
// nodes that static friction holds are moved back, without a velocity. Contacts with links of a btMultiBody
// stay Bullet's; on triangle meshes there is friction, but adhesion only in contact.
class StockContacts {
  public:
    // @pre the body is in the world, and its solids are at their positions at the end of the substep
    void rewrite(const btCollisionWorld& world, btSoftBody& body, Friction& sheetFriction);

  private:
    friend class BulletPass;
    void state(BulletPass& pass);

    // A node that a solid may hold.
    struct Held {
        int node;
        std::size_t solid;  // index
        SurfacePoint surface;
        btScalar approach;  // normal motion that the contact stops, m; 0 if the node only adheres
        bool isInContact;
        double adhesion;  // N
        double friction;  // friction coefficient
    };
    // The position at which static friction holds a node.
    struct Stuck {
        const btCollisionObject* object = nullptr;
        btVector3 position = btVector3(0, 0, 0);  // in the coordinates of the object
    };

    void rewrite(btSoftBody::RContact& contact, btSoftBody& body, const Friction& sheetFriction);
    std::size_t indexOf(const btCollisionObject& object, const btSoftBody& body);
    void add(const Held& held);
    void findAdhering(btSoftBody& body, const Friction& sheetFriction);
    void hold(btSoftBody& body, const Held& held, btScalar reach);
    // Moves a node that static friction holds back along the surface to its anchor point.
    void stick(btSoftBody& body, const Held& held);

    ContactOrder order_;
    MetSolids met_;
    Solids solids_;
    std::vector<Held> held_;
    // For each node.
    std::vector<int> heldAt_;                          // its last entry in held_; -1 if there is none
    std::vector<const btCollisionObject*> adheresTo_;  // adhesive bonds as they are formed
    std::vector<Stuck> stuck_, stuckBefore_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
