// Wet friction and cling of sheets that Bullet's own solver moves in a soft-rigid world.
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

// Rewrites the contacts that Bullet has found, before it solves them, so that each stops its node on the way
// to the solid and nothing else. Friction and the pull of bonds are done here, at once. As Bullet solves links
// after contacts, they pull nodes into solids and along them; here those are lifted out again, and those that
// friction holds put back, without a velocity. Contacts with links of a btMultiBody stay Bullet's; with
// triangle meshes there is friction, but no bond outside of contact.
class StockContacts {
  public:
    // @pre the body is in the world, and its solids are where they are as the substep ends
    void rewrite(const btCollisionWorld& world, btSoftBody& body, Friction& sheetFriction);

  private:
    friend class BulletPass;
    void state(BulletPass& pass);

    // A node that a solid may hold.
    struct Held {
        int node;
        std::size_t solid;  // index
        SurfacePoint surface;
        btScalar approach;  // that the contact stops, m; 0 for a node that has a bond only
        bool isInContact;
        double adhesion;  // N
        double friction;  // coefficient, 1
    };
    // Where friction has held a node.
    struct Stuck {
        const btCollisionObject* object = nullptr;
        btVector3 position = btVector3(0, 0, 0);  // as the object sees it
    };

    void rewrite(btSoftBody::RContact& contact, btSoftBody& body, const Friction& sheetFriction);
    void add(const Held& held);
    void findAdhering(btSoftBody& body, const Friction& sheetFriction);
    void hold(btSoftBody& body, const Held& held, btScalar reach);
    // Puts a node that friction holds back along the surface to where it has held it before.
    void stick(btSoftBody& body, const Held& held);

    ContactOrder order_;
    MetSolids met_;
    Solids solids_;
    std::vector<Held> held_;
    // Of each node.
    std::vector<int> heldAt_;                          // the last in held_; -1 for none
    std::vector<const btCollisionObject*> adheresTo_;  // as they come to be
    std::vector<Stuck> stuck_, stuckBefore_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
