// Contacts of sheets that small steps move: with themselves, with each other, and with other soft bodies.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "bullet/cloth_contact/contact_blocks.h"
#include "bullet/contact/friction.h"
#include "bullet/small_steps/contact_memory.h"
#include "bullet/small_steps/contact_search.h"
#include "bullet/small_steps/guest_cloth.h"
#include "bullet/small_steps/meeting_cloth.h"
#include "bullet/small_steps/small_step_sheet.h"
#include "bullet/small_steps/untangler.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// What comes near is found at the start of each substep, from where the nodes are and how they move, and again once one
// has left its way. Each contact is of a node with a face of cloth, or of two edges where the cloth is folded or ends.
// It keeps the sum of both margins; edges half of that, so that level layers are carried by their nodes.
//
// Nodes stay on the side of the cloth where they were found; contacts remember that side as long as both are near. A
// node that was forced through does not go deeper, but may come back.
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
    // Whether a sheet, by its index, has contacts, which may move its nodes.
    bool meets(std::size_t sheet) const {
        const auto first = pairs_.begin(), end = first + static_cast<std::ptrdiff_t>(pairCount_);
        return std::any_of(first, end, [&](const ClothPair& pair) {
            return (pair.one == sheet || pair.other == sheet) && !pair.contacts.empty();
        });
    }
    // Whether cloth has pushed or pulled a sheet, by its index, in this small step.
    bool touches(std::size_t sheet) const { return cloths_[sheet].touches; }
    // Whether it has touched other cloth in this substep.
    bool hasTouchedOthers(std::size_t sheet) const { return cloths_[sheet].hasTouchedOthers; }
    // Called in each small step: before the sheets move; then once, and in each sweep; and when solids have moved
    // the nodes too.
    void beginStep();
    void goOn();
    // @return the farthest that a contact has moved cloth, as a fraction of the distance that it keeps
    float solve(bool backwards);
    void endStep();
    // A contact that acts, between points of two cloths, or of one. Either point is given by nodes and weights that add
    // up to 1.
    struct Acting {
        btSoftBody *first, *second;
        int ofFirst;  // number of nodes that are of the first
        std::array<int, 4> nodes;
        std::array<float, 4> weights;
        Eigen::Vector3f normal;  // from the second to the first
        float area;              // of the node on a face, m2; 0 for edges
        float force;             // along the normal, N; at least 0
    };
    // Calls a function with each, as of the last small step.
    template <typename Function>
    void forEachActing(Function function) const {
        for (std::size_t p = 0; p < pairCount_; ++p)
            for (const PairContact& contact : pairs_[p].contacts)
                if (isActing(contact)) function(acting(pairs_[p], contact));
    }
    // Writes the contacts that have touched to the lists of the bodies, the new positions of guests, and the
    // adhesive bonds of sheets.
    void finish();

  private:
    MeetingCloth& newCloth();
    void addSheet(const Sheet& sheet);
    std::size_t addGuest(btSoftBody& body);
    void forgetOtherGuests();
    std::size_t indexOfCloth(btSoftBody& body);
    void addPair(std::size_t one, std::size_t other);

    void findTangles();
    void findWhatIsDue();
    void fillBlocks();
    void addToBlocks(ClothPair& pair);
    void notePushes();
    void noteTouches();
    void findAgain(ClothPair& pair);
    void find(ClothPair& pair, const ContactMemory& memory, const ContactMemory& memoryOfOther);
    void remember();
    void remember(const ClothPair& pair, const PairContact& contact, ContactMemory& to) const;
    void rememberBonds();

    void updateAdhesion();
    void updateAdhesion(const ClothPair& pair, PairContact& contact) const;
    const MeetingCloth& clothOfNode(const ClothPair& pair, const PairContact& contact) const {
        return cloths_[contact.isOfOther ? pair.other : pair.one];
    }
    const MeetingCloth& clothOfFace(const ClothPair& pair, const PairContact& contact) const {
        return cloths_[contact.isOfOther ? pair.one : pair.other];
    }
    static bool isActing(const PairContact& contact);
    Acting acting(const ClothPair& pair, const PairContact& contact) const;
    void list(const ClothPair& pair, const PairContact& contact) const;

    std::vector<std::pair<btSoftBody*, btSoftBody*>> met_;
    std::map<const btSoftBody*, GuestCloth> guests_;
    std::vector<MeetingCloth> cloths_;
    std::size_t clothCount_ = 0;  // in use; the others keep the capacity of their arrays
    std::vector<ClothPair> pairs_;
    std::size_t pairCount_ = 0;  // in use
    ContactSearch search_;
    Untangler untangler_;
    ContactBlocks blocks_;
    std::vector<const ClothPair*> groupsOf_;  // the pair of each group of blocks
    std::vector<ClothContact*> ofGroup_;
    ContactMemory memory_, memoryOfOther_;  // of a pair, while its contacts are found again
    bool canAdhere_ = false;                // whether any sheet is wet enough
    struct Nearest {
        const ClothPair* pair;
        PairContact* contact;
    };
    std::vector<Nearest> nearest_;  // of each node of all cloths
    double smallStep_ = 0;          // s
    double substep_ = 0;            // s
    int stepsLeft_ = 0;             // small steps until the end of the substep
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
