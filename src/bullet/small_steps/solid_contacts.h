// Contacts of a sheet with solids: found once per substep, solved in each small step.
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

// Each contact is a plane that moves with the solid, and keeps its node on one side: the tangent plane at the
// surface point nearest to the node at the start of the substep. So a node never passes through a convex
// solid that does not rotate, however fast or thin it is. Contacts include nodes that might reach a solid
// within the substep. A node that adheres to the solid is also held back on the other side, up to the force
// and the reach of adhesion.
class SolidContacts {
  public:
    void clear();

    // Finds the nodes of a sheet that might touch a solid within the substep, or adhere to it.
    void find(btSoftBody& body, const SmallStepSheet& sheet, const Friction& sheetFriction,
              const btCollisionObjectWrapper& solid, double substep, Solids& solids);

    // Computes the planes for the substep, and moves nodes out of solids that they start in.
    void begin(const btSoftBody& body, SmallStepSheet& sheet, const Solids& solids);

    // Keeps nodes on their side of the planes, with Coulomb friction along them.
    void solve(SmallStepSheet& sheet, Solids& solids);

    // Writes the contacts that have touched to m_rcontacts, and the adhesive bonds to the Friction of the
    // sheet.
    void finish(btSoftBody& body, Friction& sheetFriction, const Solids& solids, double substep) const;

  private:
    struct Touching;
    struct Contact {
        int node;
        float normal[3];
        float gap;       // from the plane at the end position of the solid to the node at its start, m
        float friction;  // friction coefficient
        float adhesion;  // adhesive force, N
        bool adheres;
        bool touched;
    };
    // Data that only few contacts need, at the same index.
    struct SolidPoint {
        std::size_t solid;
        const btCollisionShape* shape;
        bool isTriangle;  // whether it is a triangle of a mesh
        btTransform shapeInSolid;
        btVector3 point;   // on the plane, at the start of the substep; later at its end
        btVector3 normal;  // likewise
        btVector3 arm;     // from the solid's centre of mass to the point, at the end of the substep
        btScalar response;
        btScalar distance;  // of the node from the point when it was found, m
        bool facesNode;     // whether the normal points to the node, or is that of the triangle
    };

    void findNode(btSoftBody& body, const SmallStepSheet& sheet, std::size_t n, const Touching& with);
    // The slot for the contact of a node with a mesh; see meshContacts_.
    std::size_t indexOnMesh(std::size_t n, const SolidPoint& solidPoint, const btVector3& start);
    // Removes contacts that would stop a node on level ground of several parts; see flat_neighbours.h.
    // Triangles that rise above the nearest plane are kept.
    void choose(const btSoftBody& body, const Solids& solids);
    // Sorts contacts by the index of the solid in the world. Bullet reports them in the order in which the
    // objects first met, which is unknown to restored sheets.
    void order(const Solids& solids);
    void choose(const btVector3& start, const SolidPoint& nearest, btScalar margin, std::size_t other,
                const Solids& solids);
    void removeLeftOut();
    // Moves the plane to the position of the solid at the end of the substep.
    void follow(SolidPoint& solidPoint, const btSoftBody& body, const btVector3& start,
                const Solid& solid) const;
    void hold(SmallStepSheet& sheet, const Contact& contact, const SolidPoint& solidPoint, Solid& solid,
              float depth) const;

    std::vector<Contact> contacts_;
    std::vector<SolidPoint> solidPoints_;
    btScalar reach_ = 0;  // of adhesion, m
    // A node may be near many triangles of a mesh. For each of six directions only the nearest triangle that
    // faces this direction is kept. For each node, its contacts with the last processed mesh; -1 for none.
    std::vector<std::array<int, 6>> meshContacts_;
    const btCollisionObject* mesh_ = nullptr;
    std::vector<std::size_t> order_;
    std::vector<Contact> unorderedContacts_;
    std::vector<SolidPoint> unorderedSolidPoints_;
    std::vector<int> lastOfNode_,
        before_;  // last contact of each node, and the previous one of each contact; -1 for none
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
