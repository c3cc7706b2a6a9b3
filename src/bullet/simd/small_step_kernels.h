// The hot loops of the small steps: once for any processor, and once eight at a time.
#pragma once

#include <cstddef>
#include <cstdint>

#include "bullet/simd/nodes.h"

namespace drench {

// Wet over dry, of the cloth around a node.
struct alignas(16) NodeRatios {
    float stretch, bending, bendingFriction, unused;
};

// Eight links. Places that are not used stand between the spare node and itself.
struct alignas(32) LinkBlock {
    std::int32_t first[blockWidth], second[blockWidth];
    float alongX[blockWidth], alongY[blockWidth], alongZ[blockWidth];  // as the substep began, m
    float restLength[blockWidth];                                      // m
    float firstFraction[blockWidth],
        secondFraction[blockWidth];  // of a stretch that the nodes take back, 0 to 1
};

// Weights of eight plates: of the positions of six nodes in three components of the curvature, 1/m2.
struct alignas(32) PlateWeights {
    float of[3][6][blockWidth];
};

// Eight plates.
struct alignas(32) PlateBlock {
    std::int32_t nodes[6][blockWidth];
    float fraction[3]
                  [blockWidth];  // of each component that is taken back, over the weights and inverse masses
    std::int32_t weights;        // which of the weights
};

// What eight plates need once a substep.
struct alignas(32) PlateState {
    float area[blockWidth];     // m2
    float slid[3][blockWidth];  // curvature at which friction rests, 1/m
};

// Bending of the dry cloth.
struct PlateLaws {
    float bending;            // bending rigidity, N m
    float frictionLimit;      // moment per width at which bending friction slides, N
    float frictionStiffness;  // bending rigidity of friction that holds, over that of the cloth
};

// How plates are divided in time. Cloth is so soft to bend that its moments may stand for several small steps.
struct PlateTimes {
    float smallStep;  // s
    float every;      // so many small steps
};

// The constant by which a link's stretch is divided before its nodes take it back: w for hard links, w / 2 + 1
// / (k h^2) for those that a sweep resolves, w the sum of inverse masses; see link_constants.h. Between two
// pins 1, as nothing moves.
// @param compliance  1 / (k h^2), 1/kg
static inline float linkDivisor(float inverseMass, float compliance) {
    const float soft = 0.5f * inverseMass + compliance;
    const float constant = soft > inverseMass ? soft : inverseMass;
    return constant > 0 ? constant : 1;
}

// The share of a component of the curvature that a plate takes back, after the same rule. All three
// components at once must not take back more than there is, hence the sum of their responses as the limit.
// @param response     of this component to its own moment, the sum of inverse masses x squared weights
// @param all          the sum of the three responses
// A plate whose moments stand for n small steps moves its nodes in each of them by the n-th part of the n-th
// part of what would put it right: n steps of so much more speed each come to the whole.
// @param compliance   1 / (rigidity x area x (n h)^2)
static inline float plateFraction(float response, float all, float compliance, float every) {
    const float soft = 0.5f * response + compliance;
    return 1 / ((soft > all ? soft : all) * every * every);
}

struct SmallStepKernels {
    const char* name;

    // Goes on for one small step: what corrections have added to the steps of the nodes since the last one
    // stays with them, so `steps` <- (steps + moved - predicted) x keep + push and moved, predicted <-
    // moved + steps. (The difference of two positions would bring their rounding into the velocity.)
    // @param steps  m a small step; its inverse masses, and those of push, are 0
    void (*advance)(MovingNode* moved, MovingNode* predicted, MovingNode* steps, const MovingNode* push,
                    float keep, std::size_t count);

    // Reads off what the links need for this substep.
    // @param start           positions, m
    // @param dry             stiffness of the dry cloth, N/m, of each link in the order of the blocks
    // @param smallStepSquared  s2
    void (*prepareLinks)(LinkBlock* blocks, const float* dry, const MovingNode* start,
                         const NodeRatios* ratios, float smallStepSquared, std::size_t count);

    // One sweep over links: each takes back its stretch as far as its shares say.
    void (*solveLinks)(MovingNode* moved, const LinkBlock* blocks, std::size_t count);

    // Reads off what the plates need for this substep; lets bending friction slide; and adds to `push` what
    // the curvature at the start asks for in each small step.
    void (*preparePlates)(MovingNode* push, PlateBlock* blocks, PlateState* states,
                          const PlateWeights* weights, const PlateLaws& laws, const MovingNode* start,
                          const NodeRatios* ratios, const PlateTimes& times, std::size_t count);

    // Each plate moves nodes of `to` against what its curvature has changed at `from` since the substep
    // began; both may be the same.
    void (*solvePlates)(MovingNode* to, const MovingNode* from, const PlateBlock* blocks,
                        const PlateWeights* weights, std::size_t count);
};

// For any processor.
const SmallStepKernels& scalarKernels();
// The fastest that this processor has.
const SmallStepKernels& bestKernels();

}  // namespace drench
