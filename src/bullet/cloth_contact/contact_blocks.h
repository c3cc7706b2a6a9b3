// Contacts in blocks, as small steps go through them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "bullet/cloth_contact/cloth_contact.h"
#include "bullet/simd/contact_kernels.h"

namespace drench {

// One small step of contacts.
//
// Forces go on from step to step (warm starting), so that a stack of layers carries its weight although each step
// corrects each contact only a few times. Where layers overlap, they are moved apart without velocity, with a time
// constant and no faster than a limit. Where the cloth pulls them back at once, that is no velocity either. So errors do
// not become motion, and layers at rest stay at rest.
class ContactBlocks {
  public:
    // Of which cloth the first point of contacts is, and of which the second; see ContactGroup.
    struct Sides {
        std::array<MovingNode*, 2> moved, reference;
        std::array<const char*, 2> isCarried;
        std::array<std::size_t, 2> nodeCounts;
    };

    explicit ContactBlocks(const ContactKernels& kernels = bestContactKernels()) : kernels_(kernels) {}

    // @param step  length of small steps, s
    void clear(float step);
    // Adds contacts of one kind. They stay where they are until their states are read back.
    // @return index of their group
    std::size_t add(const Sides& sides, const std::vector<ClothContact*>& contacts);
    // Writes forces, and whether they have touched and adhere, to the contacts.
    void readBack() const;

    // The parts of a small step: before the nodes move; then once; then in each sweep; and when everything else has moved
    // the nodes as well.
    void beginStep();
    void goOn();
    // @return the farthest that a contact has moved both sides, as a fraction of the distance that it keeps
    float solve(bool backwards);
    void endStep();

    // Whether a contact of a group pushes or pulls in this small step, and whether one has touched in the substep.
    bool isPushing(std::size_t group) const { return groups_[group].isPushing; }
    bool hasTouched(std::size_t group) const { return groups_[group].hasTouched; }

  private:
    struct Group {
        Sides sides;
        bool areOfEdges, isPushing, hasTouched, places;
        std::size_t first, count;  // of its blocks
    };
    using Contacts = std::array<ClothContact*, blockWidth>;  // null for unused lanes
    // While blocks are being filled: contacts in each of a few, and how many.
    struct Filling {
        Contacts contacts;
        std::size_t count;
    };

    ContactGroup of(const Group& group);
    void fill(const Sides& sides, const std::vector<ClothContact*>& contacts);
    void close(Filling& filling, std::uint32_t bit, const std::array<std::uint32_t*, 2>& uses);
    void renewStrays(const Group& group);

    const ContactKernels& kernels_;
    ContactTimes times_ = {};
    std::vector<Group> groups_;
    std::vector<ContactBlock> blocks_;
    std::vector<Contacts> contacts_;             // of each block
    std::vector<std::uint8_t> strays_, places_;  // of each block
    std::array<std::vector<std::uint32_t>, 2>
        uses_;  // of each node of both cloths, a bit for each block that is being filled
};

}  // namespace drench
