// Forces of air and water on eight faces at a time.
#pragma once

#include "bullet/simd/fluid_kernels.h"
#include "bullet/simd/wide_vectors.h"

namespace drench {
namespace wide {

template <typename Node>
DRENCH_INLINE void mean(Vector& v, Eight& fourth, const Node* nodes, const FaceBlock& block) {
    Eight sums[4];
    for (std::size_t k = 0; k < 4; ++k) {
        Eight b, c;
        pair(sums[k], nodes[block.nodes[0][k]], nodes[block.nodes[0][k + 4]]);
        pair(b, nodes[block.nodes[1][k]], nodes[block.nodes[1][k + 4]]);
        pair(c, nodes[block.nodes[2][k]], nodes[block.nodes[2][k + 4]]);
        constexpr float third = 1.0f / 3;
        sums[k] = (sums[k] + b + c) * third;
    }
    transpose(v, fourth, sums);
}

// Forces at the end of the substep. For motion normal to a face of mass m, with m' the present added mass and
// m" the previous one, u' is the relative speed at the end and v the part of it that remains after the flow
// through the cloth: u' = v + k c v^2 (k the permeability), and (m + m') u' + A c v^2 dt = (m + m") u + m a
// dt, a quadratic equation for v. Along the face there is neither flow through the cloth nor added mass. So
// the force may stop the relative motion but not reverse it, and it is exact in steady states: in steady
// fall, and when held in the wind.
static void pushByFluid(FluidForce* forces, const FaceBlock* blocks, const PackedVector* positions,
                        const PackedVector* velocities, const OtherAcceleration* accelerations,
                        const FluidNode* fluid, const FluidLaws& laws, std::size_t count) {
    constexpr float tiny = 1e-30f, third = 1.0f / 3;
    const float dt = laws.substep;
    for (std::size_t i = 0; i < count; ++i) {
        const FaceBlock& block = blocks[i];
        Vector a, b, c, velocity, acceleration, around;
        Eight unused, permeability, doubleArea, pulled, through, alongSpeed;
        load(a, unused, positions, block.nodes[0]);
        load(b, unused, positions, block.nodes[1]);
        load(c, unused, positions, block.nodes[2]);
        const Vector u = {b.x - a.x, b.y - a.y, b.z - a.z}, v = {c.x - a.x, c.y - a.y, c.z - a.z};
        Vector normal = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
        dot(doubleArea, normal, normal);
        doubleArea += tiny;
        squareRoot(doubleArea);
        const Eight inverse = 1 / doubleArea;
        normal = Vector{normal.x * inverse, normal.y * inverse, normal.z * inverse};
        mean(velocity, unused, velocities, block);
        mean(acceleration, unused, accelerations, block);
        mean(around, permeability, fluid, block);

        const Eight area = 0.5f * doubleArea, restArea = eight(block.restArea);
        const Eight mass = around.z * restArea, max = laws.addedMass * restArea;
        const Eight added = around.x * max, both = mass + added, before = mass + around.y * max;
        const Eight density = laws.airDensity + (laws.waterDensity - laws.airDensity) * around.x;
        const Eight pressure = laws.pressure * density, shear = laws.shear * density * area;
        dot(pulled, acceleration, normal);
        dot(through, velocity, normal);
        const Eight momentum = before * through + mass * pulled * dt;
        Eight size = momentum * momentum;
        squareRoot(size);
        Eight root = both * both + 4 * size * (both * permeability + area * dt) * pressure;
        squareRoot(root);
        const Eight perMomentum = 2 / (both + root + tiny);  // the speed that remains
        const Eight dragAcross = area * pressure * perMomentum * perMomentum * size * momentum;
        const Eight byAcross =
            -third * mass / (both + tiny) * (dragAcross + added * pulled + (both - before) * through / dt);

        const Eight nextAcross = through + pulled * dt;
        const Vector along = {velocity.x + acceleration.x * dt - normal.x * nextAcross,
                              velocity.y + acceleration.y * dt - normal.y * nextAcross,
                              velocity.z + acceleration.z * dt - normal.z * nextAcross};
        dot(alongSpeed, along, along);
        squareRoot(alongSpeed);
        root = mass * mass + 4 * mass * shear * dt * alongSpeed;
        squareRoot(root);
        const Eight fraction = 2 * mass / (mass + root + tiny);
        const Eight byAlong = -third * shear * alongSpeed * fraction * fraction;
        const Vector force = {normal.x * byAcross + along.x * byAlong,
                              normal.y * byAcross + along.y * byAlong,
                              normal.z * byAcross + along.z * byAlong};
        for (std::size_t corner = 0; corner < 3; ++corner) add(forces, block.nodes[corner], force);
    }
}

}  // namespace wide
}  // namespace drench
