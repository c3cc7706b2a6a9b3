// The hot loop of the forces of air and water: once for any processor, and once eight faces at a time.
#pragma once

#include <cstddef>
#include <cstdint>

#include "bullet/simd/nodes.h"

namespace drench {

// Eight faces.
struct alignas(32) FaceBlock {
    std::int32_t nodes[3][blockWidth];
    float restArea[blockWidth];  // m2
};

// A node in air and water.
struct alignas(16) FluidNode {
    float fraction;        // that is under water, 0 to 1
    float fractionBefore;  // that was in the last substep, at most that of now
    float massPerArea;     // of the cloth with its water, kg/m2
    float permeability;    // speed of the fluid through the cloth per pressure, m/(s Pa)
};

// Acceleration of a node by everything but drag and added mass, m/s2.
struct alignas(16) OtherAcceleration {
    float x, y, z;
    float lifted;  // share of the node's weight that water lifts
};

// Force of the fluid on a node, N, and the inverse mass of the node, 1/kg.
struct alignas(16) FluidForce {
    float x, y, z, inverseMass;
};

// How air and water push; see FluidForces.
struct FluidLaws {
    float airDensity, waterDensity;  // kg/m3
    float pressure;                  // over the density and the square of the speed across a face, 1
    float shear;                     // over the density and the square of the speed along it, 1
    float addedMass;                 // of the water that moves along across the cloth, kg/m2
    float substep;                   // s
};

// Adds the forces of the fluid to the nodes of faces.
// @param positions   m
// @param velocities  against the fluid, m/s
using PushByFluid = void (*)(FluidForce* forces, const FaceBlock* blocks, const PackedVector* positions,
                             const PackedVector* velocities, const OtherAcceleration* accelerations,
                             const FluidNode* fluid, const FluidLaws& laws, std::size_t count);

// For any processor.
PushByFluid scalarPushByFluid();
// The fastest that this processor has.
PushByFluid bestPushByFluid();

}  // namespace drench
