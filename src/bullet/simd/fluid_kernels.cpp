#include "bullet/simd/fluid_kernels.h"

#include <cmath>

#include "bullet/simd/scalar_vectors.h"
#if defined(__GNUC__)
#include "bullet/simd/fluid_kernels_wide.h"
#endif

namespace drench {

#if defined(DRENCH_HAS_AVX2_KERNELS)
PushByFluid avx2PushByFluid();  // see kernels_avx2.cpp
#endif

namespace {

template <typename Node>
void meanOf(float* mean, const Node& a, const Node& b, const Node& c) {
    constexpr float third = 1.0f / 3;
    mean[0] = (a.x + b.x + c.x) * third;
    mean[1] = (a.y + b.y + c.y) * third;
    mean[2] = (a.z + b.z + c.z) * third;
}

// Force of the fluid on a third of a face; the vectorised form is in fluid_kernels_wide.h.
void pushFace(FluidForce* forces, const FaceBlock& block, const PackedVector* positions,
              const PackedVector* velocities, const OtherAcceleration* accelerations, const FluidNode* fluid,
              const FluidLaws& laws, std::size_t lane) {
    constexpr float tiny = 1e-30f, third = 1.0f / 3;
    const std::int32_t nodes[3] = {block.nodes[0][lane], block.nodes[1][lane], block.nodes[2][lane]};
    const std::int32_t a = nodes[0], b = nodes[1], c = nodes[2];
    float normal[3], velocity[3], acceleration[3], next[3], through = 0, pulled = 0, alongSquared = 0;
    const float area = 0.5f * normalOf(normal, positions[a], positions[b], positions[c]);
    meanOf(velocity, velocities[a], velocities[b], velocities[c]);
    meanOf(acceleration, accelerations[a], accelerations[b], accelerations[c]);
    FluidNode mean = {0, 0, 0, 0};
    for (const std::int32_t node : nodes) {
        mean.fraction += fluid[node].fraction * third;
        mean.fractionBefore += fluid[node].fractionBefore * third;
        mean.massPerArea += fluid[node].massPerArea * third;
        mean.permeability += fluid[node].permeability * third;
    }
    const float mass = mean.massPerArea * block.restArea[lane], max = laws.addedMass * block.restArea[lane],
                added = mean.fraction * max, both = mass + added, before = mass + mean.fractionBefore * max;
    const float density = laws.airDensity + (laws.waterDensity - laws.airDensity) * mean.fraction;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        through += velocity[axis] * normal[axis];
        pulled += acceleration[axis] * normal[axis];
        next[axis] = velocity[axis] + acceleration[axis] * laws.substep;
    }
    const float nextAcross = through + pulled * laws.substep;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        next[axis] -= normal[axis] * nextAcross;
        alongSquared += next[axis] * next[axis];
    }
    const float momentum = before * through + mass * pulled * laws.substep, size = std::abs(momentum);
    const float pressure = laws.pressure * density, shear = laws.shear * density * area;
    const float slowing = (both * mean.permeability + area * laws.substep) * pressure;
    const float left = 2 * size / (both + std::sqrt(both * both + 4 * size * slowing) + tiny);
    const float dragAcross = area * pressure * left * (momentum < 0 ? -left : left);
    const float across =
        mass / (both + tiny) * (dragAcross + added * pulled + (both - before) * through / laws.substep);
    const float speedAlong = std::sqrt(alongSquared);
    const float fraction =
        2 * mass / (mass + std::sqrt(mass * mass + 4 * mass * shear * laws.substep * speedAlong) + tiny);
    const float along = shear * speedAlong * fraction * fraction;
    float force[3];
    for (std::size_t axis = 0; axis < 3; ++axis)
        force[axis] = -third * (normal[axis] * across + next[axis] * along);
    for (const std::int32_t node : nodes) addTo(forces[node], force[0], force[1], force[2], 1);
}

void pushByFluid(FluidForce* forces, const FaceBlock* blocks, const PackedVector* positions,
                 const PackedVector* velocities, const OtherAcceleration* accelerations,
                 const FluidNode* fluid, const FluidLaws& laws, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t lane = 0; lane < blockWidth; ++lane)
            pushFace(forces, blocks[i], positions, velocities, accelerations, fluid, laws, lane);
}

}  // namespace

PushByFluid scalarPushByFluid() {
    return pushByFluid;
}

PushByFluid bestPushByFluid() {
#if defined(DRENCH_HAS_AVX2_KERNELS)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2PushByFluid();
#endif
#if defined(__GNUC__)
    return wide::pushByFluid;
#else
    return pushByFluid;
#endif
}

}  // namespace drench
