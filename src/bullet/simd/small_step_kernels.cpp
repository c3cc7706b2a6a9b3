#include "bullet/simd/small_step_kernels.h"

#include <cmath>

#include "bullet/simd/plain_vectors.h"
#include "bullet/simd/scalar_vectors.h"
#include "bullet/simd/strip_loops.h"
#if defined(__GNUC__)
#include "bullet/simd/small_step_kernels_wide.h"
#endif

namespace drench {

#if defined(DRENCH_HAS_AVX2_KERNELS)
const SmallStepKernels& avx2Kernels();  // see kernels_avx2.cpp
#endif

namespace {

void advance(MovingNode* moved, MovingNode* predicted, MovingNode* steps, const MovingNode* push, float keep,
             std::size_t count) {
    for (std::size_t n = 0; n < count; ++n) {
        MovingNode &node = moved[n], &step = steps[n];
        step.x = (step.x + (node.x - predicted[n].x)) * keep + push[n].x;
        step.y = (step.y + (node.y - predicted[n].y)) * keep + push[n].y;
        step.z = (step.z + (node.z - predicted[n].z)) * keep + push[n].z;
        node.x += step.x;
        node.y += step.y;
        node.z += step.z;
        predicted[n] = node;
    }
}

void advanceByFraction(const StepArrays& nodes, const MovingNode* push, float keep, float fraction,
                       std::size_t count) {
    const float squared = fraction * fraction, times = 1 / fraction;
    for (std::size_t n = 0; n < count; ++n) {
        MovingNode &node = nodes.moved[n], &step = nodes.steps[n];
        const MovingNode &before = nodes.predicted[n], &by = push[n];
        const bool isPin = !(node.inverseMass > 0);
        const float now = isPin ? 1 : squared, later = isPin ? times : 1;
        const float x = (step.x + (node.x - before.x)) * keep, y = (step.y + (node.y - before.y)) * keep,
                    z = (step.z + (node.z - before.z)) * keep;
        step = {x + by.x * now, y + by.y * now, z + by.z * now, 0};
        nodes.ahead[n] =
            nodes.expected[n] = {node.x + x * times + by.x * later, node.y + y * times + by.y * later,
                                 node.z + z * times + by.z * later, node.inverseMass};
        node = {node.x + step.x, node.y + step.y, node.z + step.z, node.inverseMass};
        nodes.predicted[n] = node;
    }
}

void correctByFraction(const StepArrays& nodes, float fraction, std::size_t count) {
    const float squared = fraction * fraction;
    for (std::size_t n = 0; n < count; ++n) {
        const MovingNode &corrected = nodes.ahead[n], &expected = nodes.expected[n];
        addTo(nodes.moved[n], corrected.x - expected.x, corrected.y - expected.y, corrected.z - expected.z,
              squared);
    }
}

void prepareLinks(LinkBlock* blocks, const float* dry, const MovingNode* start, const NodeRatios* ratios,
                  float smallStepSquared, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        LinkBlock& block = blocks[i];
        for (std::size_t lane = 0; lane < blockWidth; ++lane) {
            const auto first = block.first[lane], second = block.second[lane];
            const MovingNode &from = start[first], &to = start[second];
            block.alongX[lane] = to.x - from.x;
            block.alongY[lane] = to.y - from.y;
            block.alongZ[lane] = to.z - from.z;
            const float stiffness =
                dry[i * blockWidth + lane] * 0.5f * (ratios[first].stretch + ratios[second].stretch);
            const float constant =
                linkDivisor(from.inverseMass + to.inverseMass, 1 / (stiffness * smallStepSquared));
            block.firstFraction[lane] = from.inverseMass / constant;
            block.secondFraction[lane] = to.inverseMass / constant;
        }
    }
}

void solveLinks(MovingNode* moved, const LinkBlock* blocks, std::size_t count) {
    constexpr float tiny = 1e-30f;
    for (std::size_t i = 0; i < count; ++i) {
        const LinkBlock& block = blocks[i];
        for (std::size_t lane = 0; lane < blockWidth; ++lane) {
            MovingNode& from = moved[block.first[lane]];
            MovingNode& to = moved[block.second[lane]];
            const float x = block.alongX[lane] + (to.x - from.x);
            const float y = block.alongY[lane] + (to.y - from.y);
            const float z = block.alongZ[lane] + (to.z - from.z);
            const float stretch = 1 - block.restLength[lane] / std::sqrt(x * x + y * y + z * z + tiny);
            addTo(from, x, y, z, stretch * block.firstFraction[lane]);
            addTo(to, x, y, z, -stretch * block.secondFraction[lane]);
        }
    }
}

struct Components {
    float of[3][3];  // component of the curvature, axis
};

Components curvature(const MovingNode* nodes, const PlateBlock& block, const PlateWeights& weights,
                     std::size_t lane) {
    Components sum = {};
    for (std::size_t k = 0; k < 6; ++k) {
        const MovingNode& node = nodes[block.nodes[k][lane]];
        for (std::size_t m = 0; m < 3; ++m) {
            const float weight = weights.of[m][k][lane];
            sum.of[m][0] += weight * node.x;
            sum.of[m][1] += weight * node.y;
            sum.of[m][2] += weight * node.z;
        }
    }
    return sum;
}

// @param masses  positions whose inverse masses are used
void takeBack(MovingNode* nodes, const MovingNode* masses, const Components& components,
              const PlateBlock& block, const PlateWeights& weights, std::size_t lane) {
    for (std::size_t k = 0; k < 6; ++k) {
        const std::int32_t node = block.nodes[k][lane];
        float sum[3] = {};
        for (std::size_t m = 0; m < 3; ++m)
            for (std::size_t axis = 0; axis < 3; ++axis)
                sum[axis] += weights.of[m][k][lane] * block.fraction[m][lane] * components.of[m][axis];
        addTo(nodes[node], sum[0], sum[1], sum[2], -masses[node].inverseMass);
    }
}

void solvePlates(MovingNode* to, const MovingNode* from, const PlateBlock* blocks,
                 const PlateWeights* weights, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const PlateWeights& own = weights[blocks[i].weights];
        for (std::size_t lane = 0; lane < blockWidth; ++lane)
            takeBack(to, from, curvature(from, blocks[i], own, lane), blocks[i], own, lane);
    }
}

void slide(float* moments, PlateState& state, const float* bent, float stiffness, float limit,
           std::size_t lane) {
    constexpr float tiny = 1e-30f;
    float size = tiny;
    for (std::size_t m = 0; m < 3; ++m) {
        moments[m] = stiffness * (bent[m] - state.slid[m][lane]);
        size += moments[m] * moments[m];
    }
    const float ratio = limit / std::sqrt(size), holds = ratio < 1 ? ratio : 1;
    for (std::size_t m = 0; m < 3; ++m) {
        float& slid = state.slid[m][lane];
        slid = bent[m] - (bent[m] - slid) * holds;
        moments[m] *= holds;
    }
}

void share(PlateBlock& block, const PlateWeights& weights, const MovingNode* start, float compliance,
           float every, std::size_t lane) {
    float response[3] = {}, all = 0;
    for (std::size_t m = 0; m < 3; ++m) {
        for (std::size_t k = 0; k < 6; ++k) {
            const float weight = weights.of[m][k][lane];
            response[m] += start[block.nodes[k][lane]].inverseMass * weight * weight;
        }
        all += response[m];
    }
    for (std::size_t m = 0; m < 3; ++m)
        block.fraction[m][lane] = plateFraction(response[m], all, compliance, every);
}

float meanOfCorners(const NodeRatios* ratios, float NodeRatios::*ratio, const PlateBlock& block,
                    std::size_t lane) {
    return (ratios[block.nodes[0][lane]].*ratio + ratios[block.nodes[1][lane]].*ratio +
            ratios[block.nodes[2][lane]].*ratio) /
           3;
}

void preparePlate(MovingNode* push, PlateBlock& block, PlateState& state, const PlateWeights& weights,
                  const PlateLaws& laws, const MovingNode* start, const MovingNode* middle,
                  const NodeRatios* ratios, const PlateTimes& times, std::size_t lane) {
    const float rigidity = laws.bending * meanOfCorners(ratios, &NodeRatios::bending, block, lane);
    const float limit = laws.frictionLimit * meanOfCorners(ratios, &NodeRatios::bendingFriction, block, lane);
    const float held = rigidity * (1 + laws.frictionStiffness);

    float normal[3], bent[3], moments[3];
    normalOf(normal, middle[block.nodes[0][lane]], middle[block.nodes[1][lane]],
             middle[block.nodes[2][lane]]);
    Components components = curvature(start, block, weights, lane);
    for (std::size_t m = 0; m < 3; ++m) {
        const float* component = components.of[m];
        bent[m] = component[0] * normal[0] + component[1] * normal[1] + component[2] * normal[2];
    }
    slide(moments, state, bent, rigidity * laws.frictionStiffness, limit, lane);
    const float between = times.smallStep * times.every;
    share(block, weights, start, 1 / (held * state.area[lane] * between * between), times.every, lane);
    for (std::size_t m = 0; m < 3; ++m)
        for (std::size_t axis = 0; axis < 3; ++axis)
            components.of[m][axis] = (components.of[m][axis] * rigidity + normal[axis] * moments[m]) / held;
    takeBack(push, start, components, block, weights, lane);
}

void preparePlates(MovingNode* push, PlateBlock* blocks, PlateState* states, const PlateWeights* weights,
                   const PlateLaws& laws, const MovingNode* start, const MovingNode* middle,
                   const NodeRatios* ratios, const PlateTimes& times, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t lane = 0; lane < blockWidth; ++lane)
            preparePlate(push, blocks[i], states[i], weights[blocks[i].weights], laws, start, middle, ratios,
                         times, lane);
}

}  // namespace

const SmallStepKernels& scalarKernels() {
    static const SmallStepKernels kernels = {
        "scalar",          advance,      advanceByFraction,
        correctByFraction, prepareLinks, solveLinks,
        preparePlates,     solvePlates,  strip_loops::kernels<plain::Eight, plain::Vector>()};
    return kernels;
}

#if defined(__GNUC__)

namespace {

const SmallStepKernels& baselineKernels() {
    static const SmallStepKernels kernels = {
        "baseline vectors",      wide::advance,      wide::advanceByFraction,
        wide::correctByFraction, wide::prepareLinks, wide::solveLinks,
        wide::preparePlates,     wide::solvePlates,  strip_loops::kernels<wide::Eight, wide::Vector>()};
    return kernels;
}

}  // namespace

const SmallStepKernels& bestKernels() {
#if defined(DRENCH_HAS_AVX2_KERNELS)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2Kernels();
#endif
    return baselineKernels();
}

#else

const SmallStepKernels& bestKernels() {
    return scalarKernels();
}

#endif

}  // namespace drench
