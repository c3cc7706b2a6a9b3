// Lanes of one number or of eight, for inner loops that are written once for both. Everything is inlined or internal to a
// file, so that versions for different processors do not mix.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "bullet/simd/nodes.h"
#if defined(__GNUC__)
#include "bullet/simd/wide_vectors.h"
#endif

#if defined(__GNUC__)
#define DRENCH_LANES static inline __attribute__((always_inline))
#else
#define DRENCH_LANES static inline
#endif

namespace drench {
namespace lanes {

template <typename Real>
struct Triple {
    Real x, y, z;
};

template <typename Real>
DRENCH_LANES Triple<Real> operator+(const Triple<Real>& a, const Triple<Real>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename Real>
DRENCH_LANES Triple<Real> operator-(const Triple<Real>& a, const Triple<Real>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename Real>
DRENCH_LANES Triple<Real> operator*(const Triple<Real>& a, const Real& by) {
    return {a.x * by, a.y * by, a.z * by};
}
// Single values are returned by reference: how a processor passes eight depends on what it knows.
template <typename Real>
DRENCH_LANES void dot(Real& product, const Triple<Real>& a, const Triple<Real>& b) {
    product = a.x * b.x + a.y * b.y + a.z * b.z;
}
template <typename Real>
DRENCH_LANES void largerOf(Real& larger, const Real& a, const Real& b) {
    larger = a > b ? a : b;
}
template <typename Real>
DRENCH_LANES void smallerOf(Real& smaller, const Real& a, const Real& b) {
    smaller = a < b ? a : b;
}
template <typename Real>
DRENCH_LANES void sizeOf(Real& size, const Real& of) {
    size = of < 0 ? -of : of;
}

// One lane.
DRENCH_LANES void rootOf(float& root) {
    root = std::sqrt(root);
}
DRENCH_LANES bool any(bool is) {
    return is;
}
DRENCH_LANES float largest(float of) {
    return of;
}
DRENCH_LANES unsigned bitsOf(bool is) {
    return is ? 1u : 0u;
}
DRENCH_LANES void gather(Triple<float>& v, float& fourth, const MovingNode* nodes,
                         const std::int32_t* index) {
    const MovingNode& node = nodes[*index];
    v = {node.x, node.y, node.z};
    fourth = node.inverseMass;
}
DRENCH_LANES void scatter(MovingNode* nodes, const std::int32_t* index, const Triple<float>& by) {
    MovingNode& node = nodes[*index];
    node.x += by.x;
    node.y += by.y;
    node.z += by.z;
}

#if defined(__GNUC__)

// Eight lanes.
using wide::Eight;
using Eights = std::int32_t __attribute__((vector_size(32)));

DRENCH_LANES void rootOf(Eight& root) {
    wide::squareRoot(root);
}
DRENCH_LANES bool any(const Eights& is) {
    using Pairs = std::int64_t __attribute__((vector_size(32)));
    const auto pairs = reinterpret_cast<const Pairs&>(is);
    return (pairs[0] | pairs[1] | pairs[2] | pairs[3]) != 0;
}
DRENCH_LANES float largest(const Eight& of) {
    float most = of[0];
    for (std::size_t lane = 1; lane < blockWidth; ++lane) most = of[lane] > most ? of[lane] : most;
    return most;
}
DRENCH_LANES unsigned bitsOf(const Eights& is) {
    if (!any(is)) return 0;
    unsigned bits = 0;
    for (std::size_t lane = 0; lane < blockWidth; ++lane) bits |= is[lane] ? 1u << lane : 0u;
    return bits;
}
DRENCH_LANES void gather(Triple<Eight>& v, Eight& fourth, const MovingNode* nodes,
                         const std::int32_t* index) {
    wide::Vector at;
    wide::load(at, fourth, nodes, index);
    v = {at.x, at.y, at.z};
}
DRENCH_LANES void scatter(MovingNode* nodes, const std::int32_t* index, const Triple<Eight>& by) {
    wide::add(nodes, index, {by.x, by.y, by.z});
}

#endif

}  // namespace lanes
}  // namespace drench
