// Contacts of a sheet with solids: found once per substep, solved in each small step.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <cstdint>
#include <vector>

#include "bullet/contact/contact_law.h"
#include "bullet/contact/friction.h"
#include "bullet/contact/near_solids.h"
#include "bullet/contact/parts_in_cells.h"
#include "bullet/contact/solid_distance.h"
#include "bullet/contact/solids.h"
#include "bullet/small_steps/small_step_sheet.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Each contact is a plane that moves and turns with the solid, and keeps its node on one side: the tangent plane at the
// surface point nearest to the node. So a node never passes through a solid, however fast or thin either is. Planes have
// no end, surfaces have: once the node has moved along the solid, a new plane is found where the node is, so that what
// flies past the cloth does not push it. Contacts include nodes that might reach a solid within the substep. A node that
// adheres to the solid is also held back on the other side, up to the force and the reach of adhesion.
class SolidContacts {
  public:
    // Forgets the contacts of the last substep.
    void clear();
    // A solid is near, says Bullet's collision detection, which runs before anything moves.
    void meet(const btCollisionObject& object);

    // Adds the solids that are still there: the application's callbacks may have removed some since Bullet reported them.
    void addSolids(const btSoftBody& body, const Friction& sheetFriction, const NearSolids& near,
                   Solids& solids);
    // Finds the nodes that might touch a solid within the substep, or adhere to it, and moves nodes out of solids that
    // they start in. @pre the solids have begun
    void begin(btSoftBody& body, SmallStepSheet& sheet, const Friction& sheetFriction, const Solids& solids);
    // Whether no node has a contact.
    bool isEmpty() const { return nodes_.empty(); }
    // Keeps nodes on their side of the planes for now, so that other cloth finds them carried; `solve` then goes on
    // from there.
    void carry(SmallStepSheet& sheet, Solids& solids);
    // Calls a function with each node that a solid presses, the normal from the solid to it, and the mean force in the
    // substep, N.
    template <typename Function>
    void forEachForce(const Solids& solids, double substep, double smallStep, Function function) const {
        for (const NodeContacts& of : nodes_)
            for (std::size_t i = of.firstContact; i < of.firstContact + of.contacts; ++i)
                if (contacts_[i].pressed > 0)
                    function(of.node, normalOf(contacts_[i], solids),
                             double(contacts_[i].pressed) / (smallStep * substep));
    }
    // Keeps nodes on their side of the planes, with Coulomb friction along them.
    void solve(SmallStepSheet& sheet, Solids& solids);
    // Writes the contacts that have touched to m_rcontacts, and the adhesive bonds to the Friction of the sheet.
    // Whether any has touched in this substep.
    bool hasTouched() const;
    void finish(btSoftBody& body, Friction& sheetFriction, const Solids& solids, double substep) const;

  private:
    // A solid that Bullet has reported, by address only, and where it was then.
    struct Met {
        const btCollisionObject* object;
        int number;  // of its proxy
        btTransform start;
        bool isThere;  // still in the world when the sheet is solved
    };
    // A solid near the sheet.
    struct Touching {
        std::size_t solid;  // index
        Surface surface;
    };
    // A part of a solid that a node may touch.
    struct Candidate {
        std::size_t node, part, touching;  // indices
        std::size_t rank;                  // in the order in which they were found
        btScalar distance;                 // of the node at the start of the substep, m
        btVector3 normal;                  // then, in the world
        btScalar reach;                    // how far the node may move along the solid in the substep, m
    };
    // A part as seen from a node at some time.
    struct Sight {
        std::size_t candidate;
        btScalar distance;  // m
        btVector3 normal;   // in the world
        btScalar reach;     // how far the node may move along the solid, m
    };
    struct Contact {
        float normal[3];      // at the start of the substep
        float gap;            // from the plane to the node, both at the start of the substep, m
        float found[3];       // displacement of the node along the solid when the plane was found, m
        float friction;       // friction coefficient
        float adhesion;       // adhesive force, N
        float response;       // of the solid, 1/kg
        float pressed;        // sum of the impulses of the substep, times the small step, kg m
        float pushed;         // by `carry` in this small step, as an impulse times that step, kg m
        float dragged[3];     // and its friction, the same
        std::uint32_t solid;  // index
        bool adheres;
        bool touched;
        bool isDragged;  // whether `carry` has applied friction in this small step
    };
    // Data that only few contacts need, at the same index.
    struct Plane {
        std::size_t candidate;
        btVector3 arm;     // of the plane's point
        btVector3 offset;  // from that point to the node, both at the start of the substep, m
        btScalar rest;     // depth in which the node is left until the next substep, m
    };
    // The candidates and contacts of one node, as ranges of indices.
    struct NodeContacts {
        std::size_t node;
        std::size_t firstCandidate, candidates;
        std::size_t firstContact, contacts;
    };
    class ProxySearch;
    struct Search;
    static constexpr std::size_t maxContacts = 6;  // of a node

    void find(const SmallStepSheet& sheet, const Solid& solid, std::size_t touching);
    void gather(const btCollisionShape& shape, const Bounds& box);
    void findNode(const Search& search, std::size_t n);
    void findParts(const Search& search, std::size_t n, const btVector3& from, const btVector3& to,
                   btScalar around);
    void gatherNodes();
    void lift(SmallStepSheet& sheet, const NodeContacts& of, const Solids& solids);

    // Chooses the planes of a node among the parts in `sights_`.
    // @param poses  of the touching solids
    void choose(NodeContacts& of, const btVector3& position, const std::vector<btTransform>& poses);
    std::vector<Sight>::iterator removeBelowPlane(const btVector3& position,
                                                  const std::vector<btTransform>& poses);
    bool rises(Sight& other, const btVector3& position, const std::vector<btTransform>& poses) const;
    void writeContacts(const NodeContacts& of, const btVector3& position,
                       const std::vector<btTransform>& poses, SmallStepSheet& sheet, const Solids& solids);
    void writePlane(std::size_t contact, const btVector3& point, const btVector3& normal, std::size_t n,
                    SmallStepSheet& sheet, const Solid& solid);

    void solveNode(NodeContacts& of, SmallStepSheet& sheet, Solids& solids);
    void solveAnew(NodeContacts& of, SmallStepSheet& sheet, Solids& solids);
    void solveContact(std::size_t contact, std::size_t n, btScalar gap, SmallStepSheet& sheet, Solid& solid);
    // Displacement of a node along a solid since the start of the substep.
    btVector3 alongSolid(std::size_t contact, std::size_t n, SmallStepSheet& sheet, const Solid& solid) const;
    btScalar gapOf(std::size_t contact, const Solid& solid, const btVector3& along) const;
    // Finds the planes of a node again, where it is at the start of the small step.
    void renew(NodeContacts& of, SmallStepSheet& sheet, const Solids& solids);
    void goOn(std::size_t contact, btScalar depth);
    // Whether the node reaches the solid of a contact in the small step; the plane is then that of the place.
    bool reaches(const NodeContacts& of, std::size_t contact, SmallStepSheet& sheet, const Solid& solid);
    SurfacePoint nearestOf(const NodeContacts& of, std::size_t touching, const btVector3& point) const;
    struct Slip {
        btVector3 along;          // m
        btScalar length, giving;  // m and 1/kg
    };
    Slip slipOf(std::size_t contact, SmallStepSheet& sheet, std::size_t n, const Solid& solid,
                const btVector3& normal) const;
    static btVector3 rub(Contact& contact, const Slip& slip, btScalar most);
    static btVector3 normalOf(const Contact& contact, const Solids& solids);
    static ContactLaw lawOf(const Contact& contact, const SmallStepSheet& sheet);
    void hold(std::size_t contact, SmallStepSheet& sheet, std::size_t n, Solid& solid, btScalar depth);

    btSoftBody* body_ = nullptr;
    const Friction* sheetFriction_ = nullptr;
    btScalar margin_ = 0;  // m
    btScalar reach_ = 0;   // of adhesion, m
    std::vector<Met> met_;
    std::vector<Touching> touching_;
    std::vector<SolidPart> parts_;
    std::vector<Candidate> candidates_;
    std::vector<NodeContacts> nodes_;
    std::vector<Contact> contacts_;
    std::vector<Plane> planes_;  // at the same index
    // For use within functions.
    std::vector<SolidPart> gathered_;
    PartsInCells cells_;               // of gathered_
    std::vector<std::size_t> keptAs_;  // index in parts_ of each of gathered_
    std::vector<Sight> sights_, chosen_;
    std::vector<Contact> contactsBefore_;  // of a node, while its planes are found again
    std::vector<Plane> planesBefore_;
    std::vector<btTransform> startPoses_,
        poses_;  // of touching_: at the start of the substep and of the small step
    bool posesAreOfThisStep_ = false;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
