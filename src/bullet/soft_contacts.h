// Where sheets that small steps move meet other soft bodies, as Bullet finds it.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <deque>
#include <vector>

#include "drench/precision.h"
#include "small_step_sheet.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// Contacts of a node of one body with a face of another, of which small steps move at least one. The other
/// may be a soft body that Bullet moves: its nodes go on as Bullet has moved them, and give way here.
class SoftContacts {
  public:
    /// A sheet that takes part.
    struct Sheet {
        btSoftBody* body;
        SmallStepSheet* cloth;
    };

    void clear() { found_.clear(); }

    /// Takes contacts out of a body's list.
    /// @param first   index of the first that is to go
    /// @param other   whose faces they are with
    /// @param margin  at which the bodies rest on each other, m
    void take(btSoftBody& owner, int first, btSoftBody& other, btScalar margin);

    // Then, in each substep and each of its small steps.
    void begin(const std::vector<Sheet>& sheets, double substep, int steps);
    void advance();
    void solve();
    /// Puts those contacts that have touched back into the bodies' lists, and guests where they have come to.
    void finish();

  private:
    struct Found {
        btSoftBody* owner;  // of the node
        btSoftBody* other;  // of the face
        btSoftBody::SContact contact;
        btScalar margin;  // m
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
        bool touched;
    };
    /// A node of a body that Bullet moves, and has moved already.
    struct Guest {
        btSoftBody::Node* node;
        btVector3 start;  // m
        btVector3 own;    // its motion in the substep, m
        MovingNode moved;
        btVector3 before;  // of moved, in the current small step, m
    };

    Contact placed(const Found& found, const std::vector<Sheet>& sheets);
    /// @return where the node is as the substep begins
    btVector3 place(Contact& contact, std::size_t corner, btSoftBody::Node& node, const btSoftBody& body,
                    const std::vector<Sheet>& sheets);
    void lift(Contact& contact, float margin);
    std::size_t guestOf(btSoftBody::Node& node, bool isAwake);
    btVector3 step(const Contact& contact, std::size_t corner) const;

    std::vector<Found> found_;
    std::vector<Contact> contacts_;  // of the same index
    std::deque<Guest> guests_;       // stay where they are
    btScalar substep_ = 0;           // s
    btScalar share_ = 0;             // of a small step in the substep
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
