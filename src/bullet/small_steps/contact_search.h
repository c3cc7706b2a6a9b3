// Finds the contacts of two cloths, or of one with itself.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "bullet/cloth_contact/cloth_contact.h"
#include "bullet/cloth_contact/near_pairs.h"
#include "bullet/small_steps/meeting_cloth.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// A contact, and what it is of.
struct PairContact : ClothContact {
    int node;        // of the first cloth; for edges the first of its edge
    int face;        // in the order of the tree of the other cloth; for edges its edge
    int edge;        // -1 for a face
    bool isOfOther;  // whether the node is of the other cloth, and the face of the first
};

// Two cloths that are near each other, or one that may meet itself.
struct ClothPair {
    std::size_t one, other;  // indices of cloths; the same for a cloth with itself
    float distance;          // sum of both margins, m
    float friction;          // dry
    std::vector<PairContact> contacts;
};

class ContactSearch {
  public:
    // Finds all contacts that are possible while the nodes are on their ways, and those of nodes that adhere.
    // @param farthest              from which something comes near that is looked for, m
    // @param memory, memoryOfOther what contacts of one cloth and of the other have left
    void find(ClothPair& pair, const MeetingCloth& one, const MeetingCloth& other, float farthest,
              const ContactMemory& memory, const ContactMemory& memoryOfOther);

  private:
    void findBonds(bool areOfOther);
    void choose(const std::vector<NearFace>& near, bool isOfOther);
    void passOnForces(int node, bool isOfOther, std::size_t chosen);
    bool makeContact(const NearFace& near, bool isOfOther, PairContact& contact) const;
    bool makeContact(const NearEdges& near, PairContact& contact) const;

    ClothPair* pair_ = nullptr;
    const MeetingCloth* one_ = nullptr;
    const MeetingCloth* other_ = nullptr;
    const ContactMemory* memory_ = nullptr;
    const ContactMemory* memoryOfOther_ = nullptr;
    NearPairs near_;
    std::vector<int> bonded_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
