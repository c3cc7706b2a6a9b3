// Contacts between sheets that are moved by Bullet's own solvers.
#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/contact/friction.h"
#include "bullet/sheet/face_projection.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Keeps the nodes of a sheet outside the faces of other sheets that have a WetCloth, with wet friction and
// adhesion, once per substep, before Bullet solves anything. Normals are those at the start of the substep,
// so that nodes do not pass through a sheet within it. These contacts replace Bullet's own contacts between
// those nodes and sheets. (In the deformable world only if no other soft body has fCollision::VF_DD;
// otherwise Bullet's contacts act in addition, with the product of both m_cfg.kDF as friction.) Contacts with
// other soft bodies are left to Bullet. A sleeping sheet acts as a fixed obstacle. An impulse from a solid
// reaches the next sheet one substep later.
class ClothContacts {
  public:
    // Resolves the contacts of one sheet.
    enum class Mover { stockSolver, explicitWorld, implicitWorld };

    // @param substep  of the body, s
    // @pre the body is awake and in the world; its nodes have, or will get from their velocities, the
    //     positions that they would have at the end of the substep without contacts
    void solve(btDiscreteDynamicsWorld& world, btSoftBody& body, Friction& sheetFriction, Mover mover,
               double substep);

  private:
    // Another sheet.
    struct Partner {
        btSoftBody* body;
        const Friction* sheetFriction;
        btScalar margin;                 // of both sheets, m
        btScalar friction;               // friction coefficient when dry
        btVector3 minMotion, maxMotion;  // bounds of the motion of its nodes, m
    };
    // The nearest point on a face.
    struct Near {
        const Partner* partner;
        btSoftBody::Face* face;
        btVector3 weights;  // of its corners
        btVector3 normal;   // to the node
        btScalar gap;       // at the start of the substep, m
    };
    struct Corner {
        btSoftBody::Node* node;
        btScalar weight;       // 1 for the node, negative for the corners of the face
        btScalar inverseMass;  // 0 if the body sleeps
        bool isAwake;
    };
    struct Search;

    void findPartners(btDiscreteDynamicsWorld& world, const btSoftBody& body);
    void forgetBulletsContacts(btSoftBody& body) const;
    void findFaces(btSoftBody::Node& node);
    void keepFacing(const btSoftBody::Node& node);
    void solve(btSoftBody::Node& node, const Near& near, bool isNearest);
    void list(btSoftBody::Node& node, const Near& near) const;
    double adhesionOf(std::size_t node, const Near& near) const;
    static void lift(const Corner (&corners)[4], const btVector3& displacement);
    void push(const Corner (&corners)[4], const btVector3& displacement) const;

    btVector3 startOf(const btSoftBody::Node& node, bool isAwake) const;
    btVector3 motionOf(const btSoftBody::Node& node, bool isAwake) const;

    // Valid during a solve.
    Mover mover_ = Mover::stockSolver;
    btSoftBody* body_ = nullptr;
    Friction* sheetFriction_ = nullptr;
    btScalar substep_ = 0;  // s
    btScalar reach_ = 0;    // reach of adhesion, m; 0 without adhesion
    std::vector<Partner> partners_;
    bool meetsOthers_ = false;  // whether there are soft bodies that are left to Bullet
    std::vector<Near> near_;    // faces near the current node, the nearest first
    std::vector<const btCollisionObject*> adheresTo_;  // adhesive bonds of each node as they are formed
    btNodeStack stack_;
    FaceProjection projection_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
