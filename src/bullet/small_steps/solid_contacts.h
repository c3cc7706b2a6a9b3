// Where a sheet meets solids: found once a substep, solved in each small step.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletSoftBody/btSoftBody.h>

#include <array>
#include <vector>

#include "bullet/contact/friction.h"
#include "bullet/contact/solids.h"
#include "bullet/small_steps/small_step_sheet.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Each contact is a plane, moving with the solid, on the side of which its node stays: the tangent plane at the
// surface point nearest to the node as the substep begins. So a node never passes a convex solid that
// does not spin, however fast or thin. Nodes that might reach a solid within the substep count too. A node that is
// bonded to the solid is held back on the other side as well, as far as its bond is strong and long.
class SolidContacts {
  public:
    void clear();

    // Looks for nodes of a sheet that might touch a solid within the substep, or are bonded to it.
    void find(btSoftBody& body, const SmallStepSheet& sheet, const Friction& sheetFriction,
              const btCollisionObjectWrapper& solid, double substep, Solids& solids);

    // Places the planes for the substep, and lifts nodes out of solids that they start in.
    void begin(const btSoftBody& body, SmallStepSheet& sheet, const Solids& solids);

    // Keeps nodes on their side, against Coulomb friction along the planes.
    void solve(SmallStepSheet& sheet, Solids& solids);

    // Tells the body what it has touched, in m_rcontacts, and the grip what it is bonded to.
    void finish(btSoftBody& body, Friction& sheetFriction, const Solids& solids, double substep) const;

  private:
    struct Touching;
    struct Contact {
        int node;
        float normal[3];
        float gap;       // between the node at its start and the plane at the solid's end, m
        float friction;  // coefficient, 1
        float adhesion;  // force that it holds, N
        bool adheres;
        bool touched;
    };
    // What only few of the contacts need, of the same index.
    struct SolidPoint {
        std::size_t solid;
        const btCollisionShape* shape;
        bool isTriangle;  // of a mesh
        btTransform shapeInSolid;
        btVector3 point;   // of the plane, as the substep begins; then as it ends
        btVector3 normal;  // likewise
        btVector3 arm;     // of the point, from the solid's centre of mass, as the substep ends
        btScalar response;
        btScalar distance;  // of the node from the point, as found, m
        bool facesNode;     // whether the plane faces the node, or is that of the triangle
    };

    void findNode(btSoftBody& body, const SmallStepSheet& sheet, std::size_t n, const Touching& with);
    // Where the contact of a node with a mesh goes; see meshContacts_.
    std::size_t indexOnMesh(std::size_t n, const SolidPoint& solidPoint, const btVector3& start);
    // Leaves out contacts that would stand in the way of a node on flat ground of several parts; see
    // flat_neighbours.h. Triangles that rise above the nearest plane count by their own.
    void choose(const btSoftBody& body, const Solids& solids);
    // Puts contacts in the order of the solids in the world: Bullet tells of those in the order in which they have
    // met, which restored sheets would not know.
    void order(const Solids& solids);
    void choose(const btVector3& start, const SolidPoint& nearest, btScalar margin, std::size_t other,
                const Solids& solids);
    void removeLeftOut();
    // Moves the plane to where the solid is as the substep ends.
    void follow(SolidPoint& solidPoint, const btSoftBody& body, const btVector3& start,
                const Solid& solid) const;
    void hold(SmallStepSheet& sheet, const Contact& contact, const SolidPoint& solidPoint, Solid& solid,
              float depth) const;

    std::vector<Contact> contacts_;
    std::vector<SolidPoint> solidPoints_;
    btScalar reach_ = 0;  // of bonds, m
    // A node meets many triangles of a mesh, and stays on its side of the nearest of those that face the same
    // way, of six ways at most. The contacts with the mesh that was met last, of each node; -1 for none.
    std::vector<std::array<int, 6>> meshContacts_;
    const btCollisionObject* mesh_ = nullptr;
    std::vector<std::size_t> order_;
    std::vector<Contact> unorderedContacts_;
    std::vector<SolidPoint> unorderedSolidPoints_;
    std::vector<int> lastOfNode_,
        before_;  // the last contact of each node, and that before each contact; -1 for none
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
