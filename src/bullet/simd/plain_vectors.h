// Vectors of eight numbers for any compiler and processor, with the functions of those in wide_vectors.h.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "bullet/simd/nodes.h"

namespace drench {
namespace plain {

struct Eight {
    float of[blockWidth];
    float& operator[](std::size_t lane) { return of[lane]; }
    float operator[](std::size_t lane) const { return of[lane]; }
};

template <typename Operation>
static inline Eight each(const Eight& a, const Eight& b, Operation operation) {
    Eight result;
    for (std::size_t lane = 0; lane < blockWidth; ++lane) result[lane] = operation(a[lane], b[lane]);
    return result;
}
static inline Eight all(float number) {
    Eight result;
    for (float& of : result.of) of = number;
    return result;
}

static inline Eight operator+(const Eight& a, const Eight& b) {
    return each(a, b, [](float p, float q) { return p + q; });
}
static inline Eight operator-(const Eight& a, const Eight& b) {
    return each(a, b, [](float p, float q) { return p - q; });
}
static inline Eight operator*(const Eight& a, const Eight& b) {
    return each(a, b, [](float p, float q) { return p * q; });
}
static inline Eight operator/(const Eight& a, const Eight& b) {
    return each(a, b, [](float p, float q) { return p / q; });
}
static inline Eight operator+(const Eight& a, float b) {
    return a + all(b);
}
static inline Eight operator*(const Eight& a, float b) {
    return a * all(b);
}
static inline Eight operator*(float a, const Eight& b) {
    return all(a) * b;
}
static inline Eight operator-(float a, const Eight& b) {
    return all(a) - b;
}
static inline Eight operator/(float a, const Eight& b) {
    return all(a) / b;
}

static inline void squareRoot(Eight& v) {
    for (float& of : v.of) of = std::sqrt(of);
}

struct Vector {
    Eight x, y, z;
};

template <typename Node>
static inline void load(Vector& v, Eight& fourth, const Node* nodes, const std::int32_t* index) {
    for (std::size_t lane = 0; lane < blockWidth; ++lane) {
        const Node& node = nodes[index[lane]];
        v.x[lane] = node.x;
        v.y[lane] = node.y;
        v.z[lane] = node.z;
        fourth[lane] = node.inverseMass;
    }
}

template <typename Node>
static inline void put(Node* nodes, const std::int32_t* index, const Vector& v, const Eight& fourth) {
    for (std::size_t lane = 0; lane < blockWidth; ++lane)
        nodes[index[lane]] = {v.x[lane], v.y[lane], v.z[lane], fourth[lane]};
}

// Brings lane l + by to lane l.
static inline void turn(Eight& v, int by) {
    const Eight before = v;
    for (std::size_t lane = 0; lane < blockWidth; ++lane)
        v[lane] = before[(lane + static_cast<std::size_t>(by)) % blockWidth];
}

}  // namespace plain
}  // namespace drench
