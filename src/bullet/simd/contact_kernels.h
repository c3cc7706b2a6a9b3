// Inner loops of the contacts of cloth with cloth in small steps: scalar, and for eight contacts at a time.
#pragma once

#include <cstddef>
#include <cstdint>

#include "bullet/simd/nodes.h"

namespace drench {

// Eight contacts between points of cloth, each with a plane between them; no two of them share a node. Unused lanes are
// not active, and name nodes of another lane. See ClothContact for what the values mean.
struct alignas(32) ContactBlock {
    std::int32_t nodes[4][blockWidth];  // a node and the corners of a face; or the ends of two edges
    float weights[4][blockWidth];
    float inverseMass[4][blockWidth];  // 1/kg
    float normal[3][blockWidth];
    float gap[blockWidth];       // if nothing had moved since the start of the substep, m
    float response[blockWidth];  // to an impulse along the normal, 1/kg
    float distance[blockWidth];  // m
    float isActive[blockWidth];  // 1 or 0

    float slipWeights[4][blockWidth];
    float axis[3][blockWidth];
    // Of the last two corners of the face, the first has minus both; or of the second end of either edge, the first
    // has minus that.
    float turning[2][3][blockWidth];
    float friction[blockWidth];      // coefficient
    float adhesion[blockWidth];      // N
    float reach[blockWidth];         // m
    float renewedAt[3][blockWidth];  // m

    float gapBefore[blockWidth];      // at the start of the small step, m
    float slidBefore[3][blockWidth];  // m
    float push[blockWidth];           // in the small step, as the distance that it moves both, m
    float drag[3][blockWidth];        // force of friction, that goes on, times time squared, kg m
    float force[blockWidth];          // along the normal, that goes on, N
    float adheres[blockWidth];        // 1 or 0
    float touched[blockWidth];        // 1 or 0

    float placed[blockWidth];      // how far it was placed apart in the small step, m
    float notSettled[blockWidth];  // and what is left of that, m
    float opened
        [blockWidth];  // by how much the nodes, less the reference, have opened it when settling begins, m
};

// Blocks of contacts of the same kind, of the same two cloths, or of one with itself.
struct ContactGroup {
    MovingNode* moved[2];      // of the cloth of the first point, and of that of the second
    MovingNode* reference[2];  // from which their velocity counts: a shift of both adds none
    const char* isCarried[2];  // by a solid
    bool areOfEdges;           // or of a node and a face
    ContactBlock* blocks;
    std::uint8_t* strays;  // of each block: a bit for each lane whose plane has to be found again
    std::uint8_t* places;  // of each block: whether it was placed apart, and not all of that is settled
    std::size_t count;     // of blocks
};

// What a small step needs to know.
struct ContactTimes {
    float square;   // of its length, s2
    float closing;  // fraction of an overlap that it resolves
    float fastest;  // and its limit, as a fraction of the distance
};

struct ContactsSolved {
    float most = 0;           // by how much one has moved both sides, as a fraction of the distance
    bool isPushing = false;   // whether any pushes or pulls now
    bool hasTouched = false;  // whether any has touched in the substep
};

// A node moves at most so many times as far as its contact asks for. Where it is the only one that is free, at the far
// end of a face, it would have to move by any multiple.
inline constexpr float longestLever = 4;

// In each small step, of all contacts, in this order: the first two before the nodes move; then once; then in each sweep;
// and the last three, of which the second several times, when everything else has moved the nodes as well.
struct ContactKernels {
    // Moves layers that overlap apart without velocity.
    // @return whether there were any
    bool (*separate)(const ContactGroup& group, const ContactTimes& times);
    // Notes where both sides are, and which planes have to be found again.
    // @return whether there are any
    bool (*begin)(const ContactGroup& group);
    // Applies the forces of the last small step.
    // @return whether there are any
    bool (*goOn)(const ContactGroup& group, const ContactTimes& times);
    ContactsSolved (*solve)(const ContactGroup& group, const ContactTimes& times, bool backwards);
    void (*beginSettling)(const ContactGroup& group);
    // Where the cloth has pulled back what was placed apart, that is no velocity either.
    void (*settle)(const ContactGroup& group);
    // Finds the forces that go on.
    void (*finish)(const ContactGroup& group, const ContactTimes& times);
};

// Scalar version, for any processor.
const ContactKernels& scalarContactKernels();
// The fastest version that this processor supports.
const ContactKernels& bestContactKernels();

}  // namespace drench
