// Nodes as the hot loops read them: four numbers side by side, which the processor takes at once.
#pragma once

#include <cstddef>

namespace drench {

// A vector of a node.
struct alignas(16) PackedVector {
    float x, y, z, unused;
};

// How far a node has come since the substep began, m, and its inverse mass, 1/kg. Displacements stay small,
// so that single precision resolves what gravity adds in the shortest step.
struct alignas(16) MovingNode {
    float x, y, z, inverseMass;
};

// So many elements of a mesh are calculated at once; no two of a block share a node.
inline constexpr std::size_t blockWidth = 8;

}  // namespace drench
