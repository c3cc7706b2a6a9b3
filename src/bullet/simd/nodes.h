// Nodes as the inner loops read them: four adjacent numbers, which the processor handles at once.
#pragma once

#include <cstddef>

namespace drench {

// A vector of a node.
struct alignas(16) PackedVector {
    float x, y, z, unused;
};

// Displacement of a node since the start of the substep, m, and its inverse mass, 1/kg. Displacements are
// small, so single precision resolves what gravity adds in the shortest step.
struct alignas(16) MovingNode {
    float x, y, z, inverseMass;
};

// Number of elements of a mesh that are processed at once; no two elements of a block share a node.
inline constexpr std::size_t blockWidth = 8;

}  // namespace drench
