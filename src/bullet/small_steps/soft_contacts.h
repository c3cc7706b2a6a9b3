// Contacts between sheets that small steps move and other soft bodies.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <deque>
#include <vector>

#include "bullet/contact/friction.h"
#include "bullet/sheet/face_projection.h"
#include "bullet/small_steps/small_step_sheet.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Contacts of a node of one body with a face of another, at least one of which is moved by small steps. The
// other may be a soft body that Bullet moves (a guest): its nodes continue on Bullet's path, and react to
// contacts here.
//
// A node stays on the side of the cloth where its last contact held it. If it is on the other side at the start
// of a substep, it is moved back through the cloth.
//
// What pushes and what only separates: at the start of a substep, overlapping cloth is separated a little,
// without velocity, and the rest of the overlap is then allowed. So an overlap never becomes motion. The
// exception is the depth that the forces of the last substep have left: one pass over all contacts in each
// small step leaves a stack of layers slightly compressed, and this compression carries the layers above. It
// must stay as it is, or the stack would fall into it again in each substep and never rest.
class SoftContacts {
  public:
    // A sheet that small steps move.
    struct Sheet {
        btSoftBody* body;
        SmallStepSheet* cloth;
        Friction* sheetFriction;
    };

    // Forgets everything but the capacity of its arrays.
    void clear();
    // Remembers sides and depths of the contacts that a body lists from the last substep. Called at the start
    // of each substep, before the list is emptied.
    void remember(const btSoftBody& body);

    // Finds contacts of the nodes of one body with the faces of another, in Bullet's tree of faces; see
    // prepareFaceTree.
    // @param ofNodes, sheetFriction  of the body of the nodes; null for guests
    void find(btSoftBody& nodes, btSoftBody& faces, const SmallStepSheet* ofNodes,
              const Friction* sheetFriction);

    // Called after that, in each substep. Separates overlapping cloth.
    void begin(const std::vector<Sheet>& sheets, double substep, int steps);
    // Called after everything that moves nodes without velocity: allows the overlap that is left.
    void allowOverlap();

    // Called in each small step.
    void advance();
    void solve();

    // Writes the contacts that have touched to the lists of the bodies, the new positions of guests, and the
    // adhesive bonds of sheets.
    void finish(const std::vector<Sheet>& sheets);

  private:
    struct Finder;
    // A face near the current node.
    struct Near {
        btSoftBody::Face* face;
        FaceProjection::Nearest nearest;
        btScalar distance;  // m
    };
    struct Found {
        btSoftBody::SContact contact;
        btScalar pressed;  // depth that the forces of the last substep have left, m
        btScalar side;     // on which the node is: 1 for that of the face's normal, -1; 0 if unknown
        bool isTilted;     // whether the nearest point is on the border of the cloth, or on a sharp fold
    };
    // The contacts of the nodes of one body with the faces of another.
    struct Pair {
        btSoftBody* owner;  // of the nodes
        btSoftBody* other;  // of the faces
        std::size_t first;  // index of the first of them in found_
        std::size_t end;
        btScalar margin;  // of both, m
    };
    struct Remembered {
        const btSoftBody::Node* node;
        const btSoftBody::Face* face;
        btVector3 normal;
        btScalar kept;  // distance of node and face, m
    };
    struct Body {
        std::vector<Remembered> remembered;  // in the order of the nodes and faces
        const Sheet* sheet = nullptr;        // null for guests
        std::vector<int> guests;             // index of each node; -1 for none
    };
    struct Contact {
        std::size_t pair, found;    // indices
        SmallStepSheet* sheets[4];  // of the node and of the three corners of the face; null for guests
        std::size_t nodes[4];       // indices, or those of guests
        MovingNode* moved[4];
        float weights[4];     // 1 for the node, negative for the corners of the face
        btVector3 normal;     // from the face to the node
        float gap;            // at the start of the substep, m
        float pressed;        // depth that may push, m
        float allowed;        // overlap that does not push, m
        btScalar side;        // as in Found
        btVector3 renewedAt;  // displacement apart for which the nearest point was found, m
        btVector3 held;       // where friction holds node and face: their displacement apart, m
        float depth;          // at the end of the last small step, m
        float push;      // in the current small step, as the distance that it moves node and face apart, m
        float maxDrag;   // of friction, in the same unit
        float friction;  // friction coefficient
        float response;  // to an impulse along the normal, 1/kg
        float adhesion;  // adhesive force, N
        float reach;     // of adhesion, m
        bool isTilted;   // as in Found
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

    Body& bodyOf(const btSoftBody& body);

    Contact placed(std::size_t pair, std::size_t found);
    // @return position of the node at the start of the substep
    btVector3 place(Contact& contact, std::size_t corner, btSoftBody::Node& node, const btSoftBody& owner);
    void separate(Contact& contact, float margin);
    void settle(Contact& contact);
    btVector3 positionOf(const Contact& contact, std::size_t corner) const;
    void renew(Contact& contact);
    static float responseOf(const Contact& contact);
    void pushApart(Contact& contact);
    static void rub(Contact& contact);
    static btVector3 apartOf(const Contact& contact);
    static void push(Contact& contact, const btVector3& apart);
    static float depthOf(const Contact& contact);
    // Lets wet cloth adhere only by the nearest contact of each node; otherwise adhesion would count several
    // times.
    void updateAdhesion(const Sheet& sheet, std::size_t first, std::size_t end);
    static void updateAdhesion(Contact& contact, const btSoftBody& other, const Friction& ofNode,
                               const Friction* ofFace);
    static btScalar adhesionDisplacement(const Contact& contact);
    std::size_t guestOf(btSoftBody::Node& node, const btSoftBody& owner);

    std::vector<Body> bodies_;  // by their index in the world
    std::vector<Near> near_;
    btNodeStack stack_;
    FaceProjection projection_;
    std::vector<Found> found_;
    std::vector<Pair> pairs_;
    std::vector<Contact> contacts_;  // in the order of the pairs
    std::deque<Guest> guests_;       // addresses stay valid
    std::vector<int> nearest_;       // nearest contact of each node of a sheet; -1 for none
    btScalar substep_ = 0;           // s
    btScalar fraction_ = 0;          // length of a small step over that of the substep
    bool isFirstStep_ = true;
};

// Prepares the tree of faces in which SoftContacts searches, so that it finds the contacts that are possible
// within the substep.
void prepareFaceTree(btSoftBody& body, const SmallStepSheet& cloth);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
