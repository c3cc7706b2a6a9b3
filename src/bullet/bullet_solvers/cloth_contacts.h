// Contacts of sheets with each other where Bullet's own solvers move them.
#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/contact/friction.h"
#include "bullet/sheet/face_projection.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Holds the nodes of a sheet off the faces of other sheets with a WetCloth, with wet friction and cling, once a
// substep, before Bullet solves anything. Normals are those of the substep's start, so that nodes do not get
// through a sheet within it. Bullet's own contacts of these nodes with those sheets make way for these. (In the
// deformable world only where no other soft body has fCollision::VF_DD; else they come on top, with the product of
// both m_cfg.kDF for friction.) Other soft bodies meet the sheet by Bullet alone. A sheet that sleeps holds others as
// something fixed. What solids push is felt by the next sheet one substep later.
class ClothContacts {
  public:
    // What moves the sheets.
    enum class Mover { stockSolver, explicitWorld, implicitWorld };

    // @param substep  of the body, s
    // @pre the body is awake and in the world; its nodes are, or have velocities to get, where the substep would end
    // without contacts
    void solve(btDiscreteDynamicsWorld& world, btSoftBody& body, Friction& sheetFriction, Mover mover,
               double substep);

  private:
    // Another sheet.
    struct Partner {
        btSoftBody* body;
        const Friction* sheetFriction;
        btScalar margin;                 // of both sheets, m
        btScalar friction;               // coefficient when dry, 1
        btVector3 minMotion, maxMotion;  // of any node, m
    };
    // The nearest point of a face.
    struct Near {
        const Partner* partner;
        btSoftBody::Face* face;
        btVector3 weights;  // of its corners
        btVector3 normal;   // to the node
        btScalar gap;       // as the substep begins, m
    };
    struct Corner {
        btSoftBody::Node* node;
        btScalar weight;       // 1, and less than 0
        btScalar inverseMass;  // 0 for one that rests
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

    // During a solve.
    Mover mover_ = Mover::stockSolver;
    btSoftBody* body_ = nullptr;
    Friction* sheetFriction_ = nullptr;
    btScalar substep_ = 0;  // s
    btScalar reach_ = 0;    // of bonds, m; 0 where nothing clings
    std::vector<Partner> partners_;
    bool meetsOthers_ = false;                         // soft bodies that are left to Bullet
    std::vector<Near> near_;                           // to the node of the moment, the nearest first
    std::vector<const btCollisionObject*> adheresTo_;  // of each node, as they come to be
    btNodeStack stack_;
    FaceProjection projection_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
