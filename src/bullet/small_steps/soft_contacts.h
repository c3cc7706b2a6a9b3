// Where sheets that small steps move meet other soft bodies.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <deque>
#include <vector>

#include "bullet/contact/friction.h"
#include "bullet/small_steps/small_step_sheet.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Contacts of a node of one body with a face of another, of which small steps move at least one. The other
// may be a soft body that Bullet moves: its nodes go on as Bullet has moved them, and give way here.
class SoftContacts {
  public:
    // A sheet that takes part.
    struct Sheet {
        btSoftBody* body;
        SmallStepSheet* cloth;
        Friction* sheetFriction;
    };

    void clear() { found_.clear(); }

    // Looks for contacts of the nodes of one body with the faces of another, in Bullet's trees.
    void find(btSoftBody& nodes, btSoftBody& faces);

    // Then, in each substep and each of its small steps.
    void begin(const std::vector<Sheet>& sheets, double substep, int steps);
    void advance();
    void solve();
    // Puts those contacts that have touched back into the bodies' lists, guests where they have come to, and
    // bonds where sheets remember them.
    void finish(const std::vector<Sheet>& sheets);

  private:
    struct Finder;
    struct Found {
        btSoftBody* owner;  // of the node
        btSoftBody* other;  // of the face
        btSoftBody::SContact contact;
        btScalar margin;    // m
        btScalar distance;  // m
    };
    struct Contact {
        SmallStepSheet* sheets[4];  // of the node, and of the three of the face; none for guests
        std::size_t nodes[4];       // or the guests' indices
        MovingNode* moved[4];
        float weights[4];  // 1, and less than 0
        btVector3 normal;  // from the face to the node
        float gap;         // as the substep begins, m
        float friction;    // coefficient, 1
        float response;    // to a push along the normal, 1/kg
        float adhesion;    // force that it holds, N
        float reach;       // of the bond, m
        bool adheres;
        bool touched;
    };
    // A node of a body that Bullet moves, and has moved already.
    struct Guest {
        btSoftBody::Node* node;
        btVector3 start;  // m
        btVector3 own;    // its motion in the substep, m
        MovingNode moved;
        btVector3 before;  // of moved, in the current small step, m
    };

    // Of what was found since then, leaves each node its nearest face, and of the others those that rise above the
    // plane of that; see flat_neighbours.h.
    void choose(std::size_t first);
    static bool rises(Found& found, const Found& nearest);

    Contact placed(const Found& found, const std::vector<Sheet>& sheets);
    // @return where the node is as the substep begins
    btVector3 place(Contact& contact, std::size_t corner, btSoftBody::Node& node, const btSoftBody& body,
                    const std::vector<Sheet>& sheets);
    void lift(Contact& contact, float margin);
    // Has wet cloth cling by the nearest contact of each node: of all of them it would be held several times.
    void updateAdhesion(const Sheet& sheet, const std::vector<Sheet>& sheets);
    static void updateAdhesion(Contact& contact, const btSoftBody& other, const Friction& ofNode,
                               const Friction* ofFace);
    static btScalar adhesionDisplacement(const Contact& contact);
    std::size_t guestOf(btSoftBody::Node& node, bool isAwake);
    btVector3 step(const Contact& contact, std::size_t corner) const;

    std::vector<Found> found_;
    std::vector<Contact> contacts_;  // of the same index
    std::deque<Guest> guests_;       // stay where they are
    std::vector<int> nearest_;       // contact of each node of a sheet; -1 for none
    btScalar substep_ = 0;           // s
    btScalar fraction_ = 0;          // of a small step in the substep
    bool isFirstStep_ = true;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
