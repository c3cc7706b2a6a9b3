// What a soft body is from step to step.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include "bullet/state/bullet_pass.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Everything of Bullet's own that later steps depend on and that is no setting: motion, masses and so pins, link
// constants, normals, sleep, bounds, the volumes in which contacts are looked for, and the contacts of the last step.
// What its trees look like plays no part, as contacts are sorted before they count.
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

// What the body has touched in the last step. Contacts with what has left the world are not saved.
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
