// Inner loops of the small steps on a sheet in strips; see strips.h.
#pragma once

#include <cstddef>
#include <cstdint>

#include "bullet/simd/nodes.h"

namespace drench {

struct PlateLaws;
struct PlateState;
struct PlateTimes;
struct PlateWeights;

// Eight nodes, one of each strip; or any vectors of theirs.
struct alignas(32) EightNodes {
    float x[blockWidth], y[blockWidth], z[blockWidth];
};

// A number of each of eight nodes.
struct alignas(32) EightNumbers {
    float of[blockWidth];
};

// Eight links. Unused lanes share nothing.
struct alignas(32) StripLinks {
    float restLength[blockWidth];  // m
    float share[blockWidth];       // of the stretch that a node corrects, over its inverse mass, kg
};

// The vectors that eight links connect.
struct StripLinkEnds {
    std::int32_t first, second;
    std::int32_t turn;  // how many strips the second node is ahead of the first
};

// The vectors that eight plates connect.
struct StripPlateNodes {
    std::int32_t vectors[6];
    std::int8_t turns[6];  // how many strips each node is ahead of the first
    bool turned;           // whether any is
    std::int32_t weights;  // index of the weights
};

// Fraction of each component of the curvature that eight plates correct, over weights and inverse masses.
struct alignas(32) StripPlates {
    float fraction[3][blockWidth];
};

// The nodes of a sheet in a substep, in strips of that length.
struct StripNodes {
    EightNodes *moved, *predicted, *steps, *ahead, *expected;
    const EightNodes* start;
    const EightNumbers* inverseMass;
    std::size_t length;
};

// The same loops as in SmallStepKernels.
struct StripKernels {
    // Reads the nodes of an array of nodes in their order, and their fourth numbers if wanted.
    void (*read)(EightNodes* to, EightNumbers* fourth, const MovingNode* from, std::size_t length);
    // Writes them back.
    void (*write)(MovingNode* to, const EightNodes* from, const EightNumbers* fourth, std::size_t length);

    void (*advance)(const StripNodes& nodes, const EightNodes* push, float keep);
    void (*advanceByFraction)(const StripNodes& nodes, const EightNodes* push, float keep, float fraction);
    void (*correctByFraction)(const StripNodes& nodes, float fraction);
    // Where the nodes will be after some steps like the last one, in `ahead`.
    void (*lookAhead)(const StripNodes& nodes, float steps);

    // @param dry     stiffness of the dry cloth, N/m; 0 in unused lanes
    // @param ratios  stretch, bending and bending friction, wet over dry, as x, y and z
    void (*prepareLinks)(StripLinks* links, const StripLinkEnds* ends, const EightNumbers* dry,
                         const EightNumbers* inverseMass, const EightNodes* ratios, float smallStepSquared,
                         std::size_t count);
    // One sweep: each node of a link corrects the stretch by `share` times its inverse mass.
    // @param moved  displacements since `start`
    void (*solveLinks)(EightNodes* moved, const EightNodes* start, const EightNumbers* inverseMass,
                       const StripLinks* links, const StripLinkEnds* ends, std::size_t count);

    // @param nodes  `expected` has positions in the middle of the substep
    void (*preparePlates)(EightNodes* push, StripPlates* plates, PlateState* states,
                          const StripPlateNodes* of, const PlateWeights* weights, const PlateLaws& laws,
                          const StripNodes& nodes, const EightNodes* ratios, const PlateTimes& times,
                          std::size_t count);
    void (*solvePlates)(EightNodes* to, const EightNodes* from, const EightNumbers* inverseMass,
                        const StripPlates* plates, const StripPlateNodes* of, const PlateWeights* weights,
                        std::size_t count);
};

}  // namespace drench
