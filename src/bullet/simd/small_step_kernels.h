// Inner loops of the small steps: scalar, and for eight elements at a time.
#pragma once

#include <cstddef>
#include <cstdint>

#include "bullet/simd/nodes.h"
#include "bullet/simd/strip_kernels.h"

namespace drench {

// Ratios of wet to dry properties of the cloth around a node.
struct alignas(16) NodeRatios {
    float stretch, bending, bendingFriction, unused;
};

// Eight links. Unused lanes link the spare node to itself.
struct alignas(32) LinkBlock {
    std::int32_t first[blockWidth], second[blockWidth];
    float alongX[blockWidth], alongY[blockWidth], alongZ[blockWidth];  // at the start of the substep, m
    float restLength[blockWidth];                                      // m
    float firstFraction[blockWidth],
        secondFraction[blockWidth];  // fraction of the stretch that each node corrects, 0 to 1
};

// Weights of eight plates: of the positions of six nodes, for three components of the curvature, 1/m2.
struct alignas(32) PlateWeights {
    float of[3][6][blockWidth];
};

// Eight plates.
struct alignas(32) PlateBlock {
    std::int32_t nodes[6][blockWidth];
    float fraction[3][blockWidth];  // corrected fraction of each component, over weights and inverse masses
    std::int32_t weights;           // index of the weights
};

// Values of eight plates that are needed once per substep.
struct alignas(32) PlateState {
    float area[blockWidth];     // m2
    float slid[3][blockWidth];  // curvature at which the friction moment is 0, 1/m
};

// Bending of the dry cloth.
struct PlateLaws {
    float bending;            // bending rigidity, N m
    float frictionLimit;      // moment per width at which bending friction slides, N
    float frictionStiffness;  // stiffness of sticking friction over the bending rigidity of the cloth
};

// Division of bending in time. Cloth is so soft in bending that its moments may be kept for several small
// steps.
struct PlateTimes {
    float smallStep;  // s
    float every;      // number of small steps between evaluations
};

// The constant by which the stretch of a link is divided before its nodes correct it: w for stiff links, w /
// 2 + 1 / (k h^2) for links that one sweep resolves, with w the sum of the inverse masses; see
// link_constants.h. 1 between two pins, where nothing moves.
// @param compliance  1 / (k h^2), 1/kg
static inline float linkDivisor(float inverseMass, float compliance) {
    const float soft = 0.5f * inverseMass + compliance;
    const float constant = soft > inverseMass ? soft : inverseMass;
    return constant > 0 ? constant : 1;
}

// The fraction of a component of the curvature that a plate corrects, by the same rule. The three components
// together must not correct more than the whole curvature, so the limit is the sum of their responses.
// @param response     of this component to its own moment, the sum of inverse masses x squared weights
// @param all          the sum of the three responses
// A plate whose moments are kept for n small steps moves its nodes in each of them by 1 / n^2 of the complete
// correction: the correction accumulates as a velocity, so n steps add up to the whole.
// @param compliance   1 / (rigidity x area x (n h)^2)
static inline float plateFraction(float response, float all, float compliance, float every) {
    const float soft = 0.5f * response + compliance;
    return 1 / ((soft > all ? soft : all) * every * every);
}

// Nodes in a step that is shorter than the longest one; see SmallStepKernels.
struct StepArrays {
    MovingNode *moved, *predicted, *steps, *ahead, *expected;
};

struct SmallStepKernels {
    const char* name;

    // Advances by one small step. What corrections have added to the displacement of the nodes since the last
    // step stays in their velocity: `steps` <- (steps + moved - predicted) x keep + push; moved, predicted <-
    // moved + steps. (Computing the velocity from the difference of two positions would add their rounding
    // errors to it.)
    // @param steps  m per small step; its inverse masses, and those of push, are 0
    void (*advance)(MovingNode* moved, MovingNode* predicted, MovingNode* steps, const MovingNode* push,
                    float keep, std::size_t count);

    // Advances by a small step that is shorter than the longest one, whose fraction it is: `push`, per longest
    // step, moves nodes by the square of that fraction (pins: per small step, completely). `ahead` and `expected`
    // get the displacements of the nodes after the longest step.
    void (*advanceByFraction)(const StepArrays& nodes, const MovingNode* push, float keep, float fraction,
                              std::size_t count);

    // Moves nodes by the square of the fraction of what corrections have added to `ahead`.
    void (*correctByFraction)(const StepArrays& nodes, float fraction, std::size_t count);

    // Computes the values of the links for this substep.
    // @param start           positions, m
    // @param dry             stiffness of the dry cloth, N/m, of each link in the order of the blocks
    // @param smallStepSquared  s2
    void (*prepareLinks)(LinkBlock* blocks, const float* dry, const MovingNode* start,
                         const NodeRatios* ratios, float smallStepSquared, std::size_t count);

    // One sweep over the links: the nodes of each correct its stretch by their fractions.
    void (*solveLinks)(MovingNode* moved, const LinkBlock* blocks, std::size_t count);

    // Computes the values of the plates for this substep, lets bending friction slide, and adds the
    // correction of the curvature at the start of the substep to `push`, for each small step.
    // @param middle  positions in the middle of the substep, by which friction is directed, so that it takes no angular
    //     momentum from cloth that turns
    void (*preparePlates)(MovingNode* push, PlateBlock* blocks, PlateState* states,
                          const PlateWeights* weights, const PlateLaws& laws, const MovingNode* start,
                          const MovingNode* middle, const NodeRatios* ratios, const PlateTimes& times,
                          std::size_t count);

    // Each plate moves the nodes of `to` against the change of its curvature at `from` since the start of the
    // substep; both may be the same array.
    void (*solvePlates)(MovingNode* to, const MovingNode* from, const PlateBlock* blocks,
                        const PlateWeights* weights, std::size_t count);

    // The same for sheets in strips.
    StripKernels strips;
};

// Scalar version, for any processor.
const SmallStepKernels& scalarKernels();
// The fastest version that this processor supports.
const SmallStepKernels& bestKernels();

}  // namespace drench
