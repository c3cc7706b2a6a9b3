// Vectors of eight nodes, in the vector types of GCC and Clang. Compiled once for each instruction set:
// everything is inlined or internal to a file, so that the versions do not mix.
#pragma once

#include <cstddef>
#include <cstdint>

#include "bullet/simd/nodes.h"

namespace drench {
namespace wide {

using Four = float __attribute__((vector_size(16)));
using Eight = float __attribute__((vector_size(32)));

struct Vector {
    Eight x, y, z;
};

#define DRENCH_INLINE static inline __attribute__((always_inline))

// The four numbers of a node.
template <typename Node>
DRENCH_INLINE Four& four(Node& node) {
    static_assert(sizeof(Node) == sizeof(Four));
    static_assert(alignof(Node) == alignof(Four));
    return reinterpret_cast<Four&>(node);
}
template <typename Node>
DRENCH_INLINE const Four& four(const Node& node) {
    static_assert(sizeof(Node) == sizeof(Four));
    static_assert(alignof(Node) == alignof(Four));
    return reinterpret_cast<const Four&>(node);
}
DRENCH_INLINE const Eight& eight(const float* values) {
    return *reinterpret_cast<const Eight*>(values);
}
DRENCH_INLINE Eight& eight(float* values) {
    return *reinterpret_cast<Eight*>(values);
}

template <typename Node>
DRENCH_INLINE void pair(Eight& both, const Node& low, const Node& high) {
    both = __builtin_shufflevector(four(low), four(high), 0, 1, 2, 3, 4, 5, 6, 7);
}

template <typename Node>
DRENCH_INLINE void putPair(Node& low, Node& high, const Eight& both) {
    four(low) = __builtin_shufflevector(both, both, 0, 1, 2, 3);
    four(high) = __builtin_shufflevector(both, both, 4, 5, 6, 7);
}

// Transposes four pairs of nodes, k and k + 4, into eight values of each component.
DRENCH_INLINE void transpose(Vector& v, Eight& fourth, const Eight* pairs) {
    const Eight xyLow = __builtin_shufflevector(pairs[0], pairs[1], 0, 8, 1, 9, 4, 12, 5, 13);
    const Eight zwLow = __builtin_shufflevector(pairs[0], pairs[1], 2, 10, 3, 11, 6, 14, 7, 15);
    const Eight xyHigh = __builtin_shufflevector(pairs[2], pairs[3], 0, 8, 1, 9, 4, 12, 5, 13);
    const Eight zwHigh = __builtin_shufflevector(pairs[2], pairs[3], 2, 10, 3, 11, 6, 14, 7, 15);
    v.x = __builtin_shufflevector(xyLow, xyHigh, 0, 1, 8, 9, 4, 5, 12, 13);
    v.y = __builtin_shufflevector(xyLow, xyHigh, 2, 3, 10, 11, 6, 7, 14, 15);
    v.z = __builtin_shufflevector(zwLow, zwHigh, 0, 1, 8, 9, 4, 5, 12, 13);
    fourth = __builtin_shufflevector(zwLow, zwHigh, 2, 3, 10, 11, 6, 7, 14, 15);
}

// Reads eight nodes, one component at a time.
template <typename Node>
DRENCH_INLINE void load(Vector& v, Eight& fourth, const Node* nodes, const std::int32_t* index) {
    Eight pairs[4];
    for (std::size_t k = 0; k < 4; ++k) pair(pairs[k], nodes[index[k]], nodes[index[k + 4]]);
    transpose(v, fourth, pairs);
}

template <typename Node>
DRENCH_INLINE void addPair(Node& low, Node& high, const Eight& both) {
    four(low) += __builtin_shufflevector(both, both, 0, 1, 2, 3);
    four(high) += __builtin_shufflevector(both, both, 4, 5, 6, 7);
}

// Adds a vector to each of eight different nodes; their fourth numbers are kept.
template <typename Node>
DRENCH_INLINE void add(Node* nodes, const std::int32_t* index, const Vector& v) {
    const Eight zero = {};
    const Eight xyLow = __builtin_shufflevector(v.x, v.y, 0, 8, 1, 9, 4, 12, 5, 13);
    const Eight xyHigh = __builtin_shufflevector(v.x, v.y, 2, 10, 3, 11, 6, 14, 7, 15);
    const Eight zLow = __builtin_shufflevector(v.z, zero, 0, 8, 1, 9, 4, 12, 5, 13);
    const Eight zHigh = __builtin_shufflevector(v.z, zero, 2, 10, 3, 11, 6, 14, 7, 15);
    addPair(nodes[index[0]], nodes[index[4]], __builtin_shufflevector(xyLow, zLow, 0, 1, 8, 9, 4, 5, 12, 13));
    addPair(nodes[index[1]], nodes[index[5]],
            __builtin_shufflevector(xyLow, zLow, 2, 3, 10, 11, 6, 7, 14, 15));
    addPair(nodes[index[2]], nodes[index[6]],
            __builtin_shufflevector(xyHigh, zHigh, 0, 1, 8, 9, 4, 5, 12, 13));
    addPair(nodes[index[3]], nodes[index[7]],
            __builtin_shufflevector(xyHigh, zHigh, 2, 3, 10, 11, 6, 7, 14, 15));
}

// Stores the sum of eight nodes as they were read and the added vectors, one component at a time.
template <typename Node>
DRENCH_INLINE void store(Node* nodes, const std::int32_t* index, const Eight* read, const Vector& v) {
    const Eight zero = {};
    const Eight xyLow = __builtin_shufflevector(v.x, v.y, 0, 8, 1, 9, 4, 12, 5, 13);
    const Eight xyHigh = __builtin_shufflevector(v.x, v.y, 2, 10, 3, 11, 6, 14, 7, 15);
    const Eight zLow = __builtin_shufflevector(v.z, zero, 0, 8, 1, 9, 4, 12, 5, 13);
    const Eight zHigh = __builtin_shufflevector(v.z, zero, 2, 10, 3, 11, 6, 14, 7, 15);
    putPair(nodes[index[0]], nodes[index[4]],
            read[0] + __builtin_shufflevector(xyLow, zLow, 0, 1, 8, 9, 4, 5, 12, 13));
    putPair(nodes[index[1]], nodes[index[5]],
            read[1] + __builtin_shufflevector(xyLow, zLow, 2, 3, 10, 11, 6, 7, 14, 15));
    putPair(nodes[index[2]], nodes[index[6]],
            read[2] + __builtin_shufflevector(xyHigh, zHigh, 0, 1, 8, 9, 4, 5, 12, 13));
    putPair(nodes[index[3]], nodes[index[7]],
            read[3] + __builtin_shufflevector(xyHigh, zHigh, 2, 3, 10, 11, 6, 7, 14, 15));
}

// Writes eight different nodes, one component at a time.
template <typename Node>
DRENCH_INLINE void put(Node* nodes, const std::int32_t* index, const Vector& v, const Eight& fourth) {
    const Eight xyLow = __builtin_shufflevector(v.x, v.y, 0, 8, 1, 9, 4, 12, 5, 13);
    const Eight xyHigh = __builtin_shufflevector(v.x, v.y, 2, 10, 3, 11, 6, 14, 7, 15);
    const Eight zwLow = __builtin_shufflevector(v.z, fourth, 0, 8, 1, 9, 4, 12, 5, 13);
    const Eight zwHigh = __builtin_shufflevector(v.z, fourth, 2, 10, 3, 11, 6, 14, 7, 15);
    putPair(nodes[index[0]], nodes[index[4]],
            __builtin_shufflevector(xyLow, zwLow, 0, 1, 8, 9, 4, 5, 12, 13));
    putPair(nodes[index[1]], nodes[index[5]],
            __builtin_shufflevector(xyLow, zwLow, 2, 3, 10, 11, 6, 7, 14, 15));
    putPair(nodes[index[2]], nodes[index[6]],
            __builtin_shufflevector(xyHigh, zwHigh, 0, 1, 8, 9, 4, 5, 12, 13));
    putPair(nodes[index[3]], nodes[index[7]],
            __builtin_shufflevector(xyHigh, zwHigh, 2, 3, 10, 11, 6, 7, 14, 15));
}

// Brings lane l + by to lane l.
DRENCH_INLINE void turn(Eight& v, int by) {
    if (by == 1) {
        v = __builtin_shufflevector(v, v, 1, 2, 3, 4, 5, 6, 7, 0);
    } else if (by == 7) {
        v = __builtin_shufflevector(v, v, 7, 0, 1, 2, 3, 4, 5, 6);
    } else {
        const Eight before = v;
        for (std::size_t lane = 0; lane < blockWidth; ++lane)
            v[lane] = before[(lane + static_cast<std::size_t>(by)) % blockWidth];
    }
}

DRENCH_INLINE void squareRoot(Eight& v) {
    for (std::size_t lane = 0; lane < blockWidth; ++lane) v[lane] = __builtin_sqrtf(v[lane]);
}

DRENCH_INLINE void dot(Eight& product, const Vector& a, const Vector& b) {
    product = a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace wide
}  // namespace drench
