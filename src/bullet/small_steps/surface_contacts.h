// Contacts of sheets that small steps move: with themselves, with each other, and with other soft bodies.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <Eigen/Core>
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "bullet/cloth_contact/cloth_contact.h"
#include "bullet/cloth_contact/near_pairs.h"
#include "bullet/contact/friction.h"
#include "bullet/small_steps/contact_memory.h"
#include "bullet/small_steps/guest_cloth.h"
#include "bullet/small_steps/small_step_sheet.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// What is near is found at the start of each substep, and again once nodes have moved along each other by about the
// margin: within that distance a contact's plane holds. Each contact is of a node with a face of cloth, or of two
// edges where the cloth is folded or ends. It keeps the sum of both margins; edges half of that, so that level layers
// are carried by their nodes.
//
// Nodes stay on the side of the cloth where they were found; contacts remember that side as long as both are near,
// so a node that was forced through comes back.
class SurfaceContacts {
  public:
    // A sheet that small steps move.
    struct Sheet {
        btSoftBody* body;
        SmallStepSheet* cloth;
        Friction* sheetFriction;
        SurfaceTree* tree;
        ContactMemory* memory;
        bool meetsItself;
    };

    // Forgets which bodies are near each other. Called at the start of each substep.
    void clear() { met_.clear(); }
    // Two bodies are near each other, says Bullet.
    void meet(btSoftBody& one, btSoftBody& other) { met_.emplace_back(&one, &other); }
    // Forgets the pairs of bodies that are no longer there.
    template <typename IsThere>
    void forgetUnless(IsThere isThere) {
        const auto isGone = [&](const auto& pair) { return !isThere(pair.first) || !isThere(pair.second); };
        met_.erase(std::remove_if(met_.begin(), met_.end(), isGone), met_.end());
    }

    void begin(const std::vector<Sheet>& sheets, double substep, int steps);
    // Whether a sheet, by its index, is near cloth.
    bool touches(std::size_t sheet) const { return cloths_[sheet].touches; }
    // Called in each small step: before the sheets move; then once, and in each sweep; and when solids have moved
    // the nodes too.
    void beginStep();
    void goOn();
    void solve();
    void endStep();
    // Writes the contacts that have touched to the lists of the bodies, the new positions of guests, and the
    // adhesive bonds of sheets.
    void finish();

  private:
    // A cloth as it takes part in this substep.
    struct Cloth {
        btSoftBody* body;
        const SmallStepSheet* sheet;  // null for guests
        Friction* sheetFriction;      // null for guests
        GuestCloth* guest;            // null for sheets
        SurfaceTree* tree;
        ContactMemory* memory;
        btVector3 origin;
        const MovingNode* start;
        MovingNode* moved;
        MovingNode* reference;   // see ClothContact
        const char* isCarried;
        float margin;            // m
        float slack;             // how far nodes may deviate before contacts are found again, m
        float adhesiveReach;     // m; 0 if nothing adheres
        std::size_t firstIndex;  // of its nodes among those of all cloths

        // Since contacts were found.
        std::vector<MovingNode> movedAt;  // then
        Eigen::Vector3f mean;             // displacement, m
        Eigen::Vector3f meanStep;         // and in the last small step, m
        float deviation;                  // of any node from the mean, m
        float growth;                     // of that in the last small step, m
        bool isDue;                       // whether they are to be found again

        bool touches;  // whether it has had contacts in this substep
    };
    struct Contact : ClothContact {
        int node;  // of the first cloth; for edges the first of its edge
        int face;  // in the order of the tree of the other cloth; for edges its edge
        int edge;  // -1 for a face
        bool isOfOther;  // whether the node is of the other cloth, and the face of the first
    };
    struct Pair {
        std::size_t one, other;  // indices of cloths; the same for a cloth with itself
        float distance;          // sum of both margins, m
        float friction;          // dry
        float slack;             // how far both may move apart before contacts are found again, m
        float used;              // of it when they were found, m
        Eigen::Vector3f between;  // mean displacement of one from that of the other then, m
        std::vector<Contact> contacts;
    };

    Cloth& newCloth();
    void addSheet(const Sheet& sheet);
    std::size_t addGuest(btSoftBody& body);
    std::size_t indexOfCloth(btSoftBody& body);
    void addPair(std::size_t one, std::size_t other);

    static void measureMotion(Cloth& cloth);
    static void restartMotion(Cloth& cloth);
    bool isDue(const Pair& pair) const;
    void findWhatIsDue();
    void find(Pair& pair);
    void remember();
    void remember(const Pair& pair, const Contact& contact);

    void choose(Pair& pair, const std::vector<NearFace>& near, bool isOfOther);
    bool makeContact(const Pair& pair, const NearFace& near, bool isOfOther, Contact& contact) const;
    bool makeContact(const Pair& pair, const NearEdges& near, Contact& contact) const;
    void place(Contact& contact, const Cloth& first, const Cloth& second, const std::array<int, 4>& nodes,
               int ofFirst) const;
    void updateAdhesion();
    void updateAdhesion(const Pair& pair, Contact& contact) const;
    const Cloth& clothOfNode(const Pair& pair, const Contact& contact) const {
        return cloths_[contact.isOfOther ? pair.other : pair.one];
    }
    const Cloth& clothOfFace(const Pair& pair, const Contact& contact) const {
        return cloths_[contact.isOfOther ? pair.one : pair.other];
    }
    void list(const Pair& pair, const Contact& contact) const;

    std::vector<std::pair<btSoftBody*, btSoftBody*>> met_;
    std::map<const btSoftBody*, GuestCloth> guests_;
    std::vector<Cloth> cloths_;
    std::size_t clothCount_ = 0;  // in use; the others keep the capacity of their arrays
    std::vector<Pair> pairs_;
    std::size_t pairCount_ = 0;  // in use
    std::vector<char> dueAgain_;  // of each pair
    NearPairs near_;
    struct Nearest {
        const Pair* pair;
        Contact* contact;
    };
    std::vector<Nearest> nearest_;  // of each node of all cloths
    double smallStep_ = 0;          // s
    double substep_ = 0;            // s
    int stepsLeft_ = 0;             // small steps until the end of the substep
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
