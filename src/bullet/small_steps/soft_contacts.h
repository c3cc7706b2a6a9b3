// Contacts between sheets that small steps move and other soft bodies.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <deque>
#include <vector>

#include "bullet/contact/friction.h"
#include "bullet/small_steps/small_step_sheet.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Contacts of a node of one body with a face of another, at least one of which is moved by small steps. The
// other may be a soft body that Bullet moves (a guest): its nodes continue on Bullet's path, and react to
// contacts here.
class SoftContacts {
  public:
    // A sheet that small steps move.
    struct Sheet {
        btSoftBody* body;
        SmallStepSheet* cloth;
        Friction* sheetFriction;
    };

    void clear() { found_.clear(); }

    // Finds contacts of the nodes of one body with the faces of another, with Bullet's trees.
    void find(btSoftBody& nodes, btSoftBody& faces);

    // Called after that, in each substep and in each of its small steps.
    void begin(const std::vector<Sheet>& sheets, double substep, int steps);
    void advance();
    void solve();
    // Writes the contacts that have touched to the lists of the bodies, the new positions of guests, and the
    // adhesive bonds of sheets.
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
        SmallStepSheet* sheets[4];  // of the node and of the three corners of the face; null for guests
        std::size_t nodes[4];       // indices, or those of guests
        MovingNode* moved[4];
        float weights[4];  // 1 for the node, negative for the corners of the face
        btVector3 normal;  // from the face to the node
        float gap;         // at the start of the substep, m
        float friction;    // friction coefficient
        float response;    // to an impulse along the normal, 1/kg
        float adhesion;    // adhesive force, N
        float reach;       // of adhesion, m
        bool adheres;
        bool touched;
    };
    // A node of a body that Bullet moves and has already moved in this substep.
    struct Guest {
        btSoftBody::Node* node;
        btVector3 start;  // m
        btVector3 own;    // its own displacement in the substep, m
        MovingNode moved;
        btVector3 before;  // moved at the start of the current small step, m
    };

    // Keeps for each node the nearest of the newly found faces, and those of the others that rise above its
    // plane; see flat_neighbours.h.
    void choose(std::size_t first);
    static bool rises(Found& found, const Found& nearest);

    Contact placed(const Found& found, const std::vector<Sheet>& sheets);
    // @return position of the node at the start of the substep
    btVector3 place(Contact& contact, std::size_t corner, btSoftBody::Node& node, const btSoftBody& body,
                    const std::vector<Sheet>& sheets);
    void lift(Contact& contact, float margin);
    // Lets wet cloth adhere only by the nearest contact of each node; otherwise adhesion would count several
    // times.
    void updateAdhesion(const Sheet& sheet, const std::vector<Sheet>& sheets);
    static void updateAdhesion(Contact& contact, const btSoftBody& other, const Friction& ofNode,
                               const Friction* ofFace);
    static btScalar adhesionDisplacement(const Contact& contact);
    std::size_t guestOf(btSoftBody::Node& node, bool isAwake);
    btVector3 step(const Contact& contact, std::size_t corner) const;

    std::vector<Found> found_;
    std::vector<Contact> contacts_;  // of the same index
    std::deque<Guest> guests_;       // addresses stay valid
    std::vector<int> nearest_;       // nearest contact of each node of a sheet; -1 for none
    btScalar substep_ = 0;           // s
    btScalar fraction_ = 0;          // length of a small step over that of the substep
    bool isFirstStep_ = true;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
