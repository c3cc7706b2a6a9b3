// The state of a soft body.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include "bullet/state/bullet_pass.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Everything in Bullet's body that later steps depend on, except settings: motion, masses and so pins, link
// constants, normals, sleep, bounds, the volumes in which contacts are searched, and the contacts of the last
// step. The structure of its trees is irrelevant, because contacts are sorted before they are used.
class BodyState {
  public:
    // @pre a body that is checked or restored has the nodes, links and faces of the one that was saved
    BodyState(btSoftBody& body, bool isDeformable) : body_(body), isDeformable_(isDeformable) {}

  private:
    friend class BulletPass;
    void state(BulletPass& pass);

    void nodes(BulletPass& pass);
    void linksAndFaces(BulletPass& pass);
    void sleep(BulletPass& pass);
    void trees(BulletPass& pass);
    void restoreFaceTree(bool wanted);

    btSoftBody& body_;
    const bool isDeformable_;
};

// Contacts of the body in the last step. Contacts with objects that have left the world are not saved.
class ContactState {
  public:
    ContactState(btSoftBody& body, bool isDeformable) : body_(body), isDeformable_(isDeformable) {}

  private:
    friend class BulletPass;
    void state(BulletPass& pass);

    void solids(BulletPass& pass);
    void softBodies(BulletPass& pass);
    void deformableSolids(BulletPass& pass);
    void deformableSoftBodies(BulletPass& pass);

    template <typename Contacts, typename IsKnown, typename Each>
    void list(BulletPass& pass, Contacts& contacts, IsKnown isKnown, Each each);
    template <typename Contact>
    void node(BulletPass& pass, Contact& contact);
    template <typename Contact>
    const btCollisionObject* face(BulletPass& pass, Contact& contact);
    void touched(BulletPass& pass, btSoftBody::sCti& found);
    bool owns(const btSoftBody::Node* node) const;

    btSoftBody& body_;
    const bool isDeformable_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
