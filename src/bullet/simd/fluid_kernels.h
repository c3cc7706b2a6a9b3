// Inner loops of the forces of air and water: scalar, and for eight faces at a time.
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
    float fraction;        // submerged fraction, 0 to 1
    float fractionBefore;  // submerged fraction in the last substep, at most the present one
    float massPerArea;     // of the cloth with its water, kg/m2
    float permeability;    // speed of the fluid through the cloth per pressure, m/(s Pa)
};

// Acceleration of a node by everything except drag and added mass, m/s2.
struct alignas(16) OtherAcceleration {
    float x, y, z;
    float lifted;  // fraction of the node's weight that buoyancy compensates
};

// Force of the fluid on a node, N, and the inverse mass of the node, 1/kg.
struct alignas(16) FluidForce {
    float x, y, z, inverseMass;
};

// Constants of the drag; see FluidForces.
struct FluidLaws {
    float airDensity, waterDensity;  // kg/m3
    float pressure;                  // normal pressure over density and squared normal speed, dimensionless
    float shear;                     // shear stress over density and squared tangential speed, dimensionless
    float addedMass;                 // added mass of water, kg/m2
    float substep;                   // s
};

// Adds the forces of the fluid to the nodes of the faces.
// @param positions   m
// @param velocities  relative to the fluid, m/s
using PushByFluid = void (*)(FluidForce* forces, const FaceBlock* blocks, const PackedVector* positions,
                             const PackedVector* velocities, const OtherAcceleration* accelerations,
                             const FluidNode* fluid, const FluidLaws& laws, std::size_t count);

// Scalar version, for any processor.
PushByFluid scalarPushByFluid();
// The fastest version that this processor supports.
PushByFluid bestPushByFluid();

}  // namespace drench
