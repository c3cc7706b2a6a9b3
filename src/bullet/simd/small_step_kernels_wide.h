// Inner loops of the small steps, for eight links or plates at a time.
#pragma once

#include "bullet/simd/small_step_kernels.h"
#include "bullet/simd/wide_vectors.h"

namespace drench {
namespace wide {

static void advance(MovingNode* moved, MovingNode* predicted, MovingNode* steps, const MovingNode* push,
                    float keep, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n) {
        const Four step = (four(steps[n]) + (four(moved[n]) - four(predicted[n]))) * keep + four(push[n]);
        four(steps[n]) = step;
        four(moved[n]) += step;
        four(predicted[n]) = four(moved[n]);
    }
}

static void advanceByFraction(const StepArrays& nodes, const MovingNode* push, float keep, float fraction,
                              std::size_t count) {
    const float squared = fraction * fraction, times = 1 / fraction;
    for (std::size_t n = 0; n < count; ++n) {
        MovingNode& moved = nodes.moved[n];
        const bool isPin = !(moved.inverseMass > 0);
        const float now = isPin ? 1 : squared, later = isPin ? times : 1;
        const Four kept = (four(nodes.steps[n]) + (four(moved) - four(nodes.predicted[n]))) * keep;
        const Four step = kept + four(push[n]) * now;
        const Four ahead = four(moved) + kept * times + four(push[n]) * later;
        four(nodes.ahead[n]) = ahead;
        four(nodes.expected[n]) = ahead;
        four(nodes.steps[n]) = step;
        four(moved) += step;
        four(nodes.predicted[n]) = four(moved);
    }
}

static void correctByFraction(const StepArrays& nodes, float fraction, std::size_t count) {
    const float squared = fraction * fraction;
    for (std::size_t n = 0; n < count; ++n)
        four(nodes.moved[n]) += (four(nodes.ahead[n]) - four(nodes.expected[n])) * squared;
}

static void prepareLinks(LinkBlock* blocks, const float* dry, const MovingNode* start,
                         const NodeRatios* ratios, float smallStepSquared, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        LinkBlock& block = blocks[i];
        Vector from, to, fromRatios, toRatios;
        Eight firstMass, secondMass, unused;
        load(from, firstMass, start, block.first);
        load(to, secondMass, start, block.second);
        load(fromRatios, unused, ratios, block.first);
        load(toRatios, unused, ratios, block.second);
        eight(block.alongX) = to.x - from.x;
        eight(block.alongY) = to.y - from.y;
        eight(block.alongZ) = to.z - from.z;
        Eight stiffness;  // from an array that need not be aligned to 32 bytes
        __builtin_memcpy(&stiffness, dry + i * blockWidth, sizeof stiffness);
        stiffness *= 0.5f * (fromRatios.x + toRatios.x);
        const Eight compliance = 1 / (stiffness * smallStepSquared);
        const Eight mass = firstMass + secondMass;
        for (std::size_t lane = 0; lane < blockWidth; ++lane) {
            const float constant = linkDivisor(mass[lane], compliance[lane]);
            block.firstFraction[lane] = firstMass[lane] / constant;
            block.secondFraction[lane] = secondMass[lane] / constant;
        }
    }
}

static void solveLinks(MovingNode* moved, const LinkBlock* blocks, std::size_t count) {
    constexpr float tiny = 1e-30f;
    for (std::size_t i = 0; i < count; ++i) {
        const LinkBlock& block = blocks[i];
        Eight from[4], to[4], apart[4];
        for (std::size_t k = 0; k < 4; ++k) {
            pair(from[k], moved[block.first[k]], moved[block.first[k + 4]]);
            pair(to[k], moved[block.second[k]], moved[block.second[k + 4]]);
            apart[k] = to[k] - from[k];
        }
        Vector along;
        Eight unused;
        transpose(along, unused, apart);
        along.x += eight(block.alongX);
        along.y += eight(block.alongY);
        along.z += eight(block.alongZ);
        Eight length = along.x * along.x + along.y * along.y + along.z * along.z + tiny;
        squareRoot(length);
        const Eight stretch = 1 - eight(block.restLength) / length;
        const Eight forward = stretch * eight(block.firstFraction);
        const Eight back = -stretch * eight(block.secondFraction);
        store(moved, block.first, from, {along.x * forward, along.y * forward, along.z * forward});
        store(moved, block.second, to, {along.x * back, along.y * back, along.z * back});
    }
}

// The weighted sum of six nodes in each of three components.
DRENCH_INLINE void curvature(Vector* components, Eight* inverseMass, const MovingNode* nodes,
                             const PlateBlock& block, const PlateWeights& weights) {
    for (std::size_t m = 0; m < 3; ++m) components[m] = Vector{};
    for (std::size_t k = 0; k < 6; ++k) {
        Vector at;
        load(at, inverseMass[k], nodes, block.nodes[k]);
        for (std::size_t m = 0; m < 3; ++m) {
            const Eight weight = eight(weights.of[m][k]);
            components[m].x += weight * at.x;
            components[m].y += weight * at.y;
            components[m].z += weight * at.z;
        }
    }
}

// Moves six nodes by the remaining correction of the components.
DRENCH_INLINE void takeBack(MovingNode* nodes, const Vector* components, const Eight* inverseMass,
                            const PlateBlock& block, const PlateWeights& weights) {
    Vector fractions[3];
    for (std::size_t m = 0; m < 3; ++m) {
        const Eight fraction = eight(block.fraction[m]);
        fractions[m] =
            Vector{components[m].x * fraction, components[m].y * fraction, components[m].z * fraction};
    }
    for (std::size_t k = 0; k < 6; ++k) {
        Vector sum = {};
        for (std::size_t m = 0; m < 3; ++m) {
            const Eight weight = eight(weights.of[m][k]);
            sum.x += weight * fractions[m].x;
            sum.y += weight * fractions[m].y;
            sum.z += weight * fractions[m].z;
        }
        const Eight by = -inverseMass[k];
        add(nodes, block.nodes[k], {sum.x * by, sum.y * by, sum.z * by});
    }
}

static void solvePlates(MovingNode* to, const MovingNode* from, const PlateBlock* blocks,
                        const PlateWeights* weights, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const PlateWeights& own = weights[blocks[i].weights];
        Vector components[3];
        Eight inverseMass[6];
        curvature(components, inverseMass, from, blocks[i], own);
        takeBack(to, components, inverseMass, blocks[i], own);
    }
}

// Unit normals of the plates' own triangles.
DRENCH_INLINE void unitNormal(Vector& normal, const MovingNode* nodes, const PlateBlock& block) {
    Vector a, b, c;
    Eight unused;
    load(a, unused, nodes, block.nodes[0]);
    load(b, unused, nodes, block.nodes[1]);
    load(c, unused, nodes, block.nodes[2]);
    const Vector u = {b.x - a.x, b.y - a.y, b.z - a.z}, v = {c.x - a.x, c.y - a.y, c.z - a.z};
    normal = Vector{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    constexpr float tiny = 1e-30f;
    Eight length = normal.x * normal.x + normal.y * normal.y + normal.z * normal.z + tiny;
    squareRoot(length);
    normal.x /= length;
    normal.y /= length;
    normal.z /= length;
}

// Friction moments, N; friction slides where they exceed the limit.
DRENCH_INLINE void slide(Eight* moments, PlateState& state, const Eight* bent, const Eight& stiffness,
                         const Eight& limit) {
    constexpr float tiny = 1e-30f;
    Eight size = {};
    size += tiny;
    for (std::size_t m = 0; m < 3; ++m) {
        moments[m] = stiffness * (bent[m] - eight(state.slid[m]));
        size += moments[m] * moments[m];
    }
    squareRoot(size);
    Eight holds = limit / size;
    for (std::size_t lane = 0; lane < blockWidth; ++lane) holds[lane] = holds[lane] < 1 ? holds[lane] : 1;
    for (std::size_t m = 0; m < 3; ++m) {
        // Where friction slides, the curvature of zero friction moment follows.
        eight(state.slid[m]) = bent[m] - (bent[m] - eight(state.slid[m])) * holds;
        moments[m] *= holds;
    }
}

// Fractions of the components that one sweep corrects; see plateFraction.
DRENCH_INLINE void share(PlateBlock& block, const PlateWeights& weights, const Eight* inverseMass,
                         const Eight& compliance, float every) {
    Eight response[3], all = {};
    for (std::size_t m = 0; m < 3; ++m) {
        response[m] = Eight{};
        for (std::size_t k = 0; k < 6; ++k)
            response[m] += inverseMass[k] * eight(weights.of[m][k]) * eight(weights.of[m][k]);
        all += response[m];
    }
    for (std::size_t m = 0; m < 3; ++m)
        for (std::size_t lane = 0; lane < blockWidth; ++lane)
            block.fraction[m][lane] = plateFraction(response[m][lane], all[lane], compliance[lane], every);
}

static void preparePlates(MovingNode* push, PlateBlock* blocks, PlateState* states,
                          const PlateWeights* weights, const PlateLaws& laws, const MovingNode* start,
                          const MovingNode* middle, const NodeRatios* ratios, const PlateTimes& times,
                          std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        PlateBlock& block = blocks[i];
        PlateState& state = states[i];
        const PlateWeights& own = weights[block.weights];
        Vector components[3], normal, corners[3];
        Eight inverseMass[6], bent[3], moments[3], unused;
        for (std::size_t k = 0; k < 3; ++k) load(corners[k], unused, ratios, block.nodes[k]);
        constexpr float third = 1.0f / 3;
        const Eight rigidity = (corners[0].y + corners[1].y + corners[2].y) * third * laws.bending;
        const Eight limit = (corners[0].z + corners[1].z + corners[2].z) * third * laws.frictionLimit;
        const Eight held = rigidity * (1 + laws.frictionStiffness);

        curvature(components, inverseMass, start, block, own);
        unitNormal(normal, middle, block);
        for (std::size_t m = 0; m < 3; ++m)
            bent[m] = components[m].x * normal.x + components[m].y * normal.y + components[m].z * normal.z;
        slide(moments, state, bent, rigidity * laws.frictionStiffness, limit);
        const float between = times.smallStep * times.every;
        share(block, own, inverseMass, 1 / (held * eight(state.area) * between * between), times.every);
        for (std::size_t m = 0; m < 3; ++m) {
            const Eight elastic = rigidity / held, friction = moments[m] / held;
            components[m].x = components[m].x * elastic + normal.x * friction;
            components[m].y = components[m].y * elastic + normal.y * friction;
            components[m].z = components[m].z * elastic + normal.z * friction;
        }
        takeBack(push, components, inverseMass, block, own);
    }
}

}  // namespace wide
}  // namespace drench
