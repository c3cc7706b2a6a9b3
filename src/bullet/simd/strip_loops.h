// Inner loops of the small steps on a sheet in strips. Compiled once for each instruction set: everything is internal
// to a file, so that the versions do not mix.
// @tparam Eight  of wide_vectors.h or plain_vectors.h
#pragma once

#include <cstddef>
#include <cstdint>

#include "bullet/simd/plain_vectors.h"
#include "bullet/simd/small_step_kernels.h"
#include "bullet/simd/strip_kernels.h"
#if defined(__GNUC__)
#include "bullet/simd/wide_vectors.h"
#endif

namespace drench {
namespace strip_loops {

using plain::load;
using plain::put;
using plain::squareRoot;
using plain::turn;
#if defined(__GNUC__)
using wide::load;
using wide::put;
using wide::squareRoot;
using wide::turn;
#endif

template <typename Eight>
static inline const Eight& as(const float* numbers) {
    return *reinterpret_cast<const Eight*>(numbers);
}
template <typename Eight>
static inline Eight& as(float* numbers) {
    return *reinterpret_cast<Eight*>(numbers);
}

static inline float* axisOf(EightNodes& nodes, std::size_t axis) {
    return nodes.x + axis * blockWidth;
}
static inline const float* axisOf(const EightNodes& nodes, std::size_t axis) {
    return nodes.x + axis * blockWidth;
}

template <typename Eight, typename Vector>
static void read(EightNodes* to, EightNumbers* fourth, const MovingNode* from, std::size_t length) {
    for (std::size_t v = 0; v < length; ++v) {
        std::int32_t index[blockWidth];
        for (std::size_t lane = 0; lane < blockWidth; ++lane)
            index[lane] = static_cast<std::int32_t>(v + lane * length);
        Vector vector;
        Eight last;
        load(vector, last, from, index);
        as<Eight>(to[v].x) = vector.x;
        as<Eight>(to[v].y) = vector.y;
        as<Eight>(to[v].z) = vector.z;
        if (fourth) as<Eight>(fourth[v].of) = last;
    }
}

template <typename Eight, typename Vector>
static void write(MovingNode* to, const EightNodes* from, const EightNumbers* fourth, std::size_t length) {
    for (std::size_t v = 0; v < length; ++v) {
        std::int32_t index[blockWidth];
        for (std::size_t lane = 0; lane < blockWidth; ++lane)
            index[lane] = static_cast<std::int32_t>(v + lane * length);
        const Vector vector = {as<Eight>(from[v].x), as<Eight>(from[v].y), as<Eight>(from[v].z)};
        put(to, index, vector, as<Eight>(fourth[v].of));
    }
}

template <typename Eight>
static void advance(const StripNodes& nodes, const EightNodes* push, float keep) {
    for (std::size_t v = 0; v < nodes.length; ++v)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Eight &moved = as<Eight>(axisOf(nodes.moved[v], axis)),
                  &predicted = as<Eight>(axisOf(nodes.predicted[v], axis)),
                  &step = as<Eight>(axisOf(nodes.steps[v], axis));
            const Eight next = (step + (moved - predicted)) * keep + as<Eight>(axisOf(push[v], axis));
            step = next;
            moved = moved + next;
            predicted = moved;
        }
}

// A pin moves completely.
template <typename Eight>
static void advanceByFraction(const StripNodes& nodes, const EightNodes* push, float keep, float fraction) {
    const float squared = fraction * fraction, times = 1 / fraction;
    for (std::size_t v = 0; v < nodes.length; ++v) {
        Eight now, later;
        for (std::size_t lane = 0; lane < blockWidth; ++lane) {
            const bool isPin = !(nodes.inverseMass[v].of[lane] > 0);
            now[lane] = isPin ? 1 : squared;
            later[lane] = isPin ? times : 1;
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Eight &moved = as<Eight>(axisOf(nodes.moved[v], axis)),
                  &predicted = as<Eight>(axisOf(nodes.predicted[v], axis)),
                  &step = as<Eight>(axisOf(nodes.steps[v], axis));
            const Eight& by = as<Eight>(axisOf(push[v], axis));
            const Eight kept = (step + (moved - predicted)) * keep;
            const Eight ahead = moved + kept * times + by * later;
            as<Eight>(axisOf(nodes.ahead[v], axis)) = ahead;
            as<Eight>(axisOf(nodes.expected[v], axis)) = ahead;
            step = kept + by * now;
            moved = moved + step;
            predicted = moved;
        }
    }
}

template <typename Eight>
static void correctByFraction(const StripNodes& nodes, float fraction) {
    const float squared = fraction * fraction;
    for (std::size_t v = 0; v < nodes.length; ++v)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Eight& moved = as<Eight>(axisOf(nodes.moved[v], axis));
            moved = moved +
                    (as<Eight>(axisOf(nodes.ahead[v], axis)) - as<Eight>(axisOf(nodes.expected[v], axis))) *
                        squared;
        }
}

template <typename Eight>
static void lookAhead(const StripNodes& nodes, float steps) {
    for (std::size_t v = 0; v < nodes.length; ++v)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Eight &moved = as<Eight>(axisOf(nodes.moved[v], axis)),
                        &predicted = as<Eight>(axisOf(nodes.predicted[v], axis)),
                        &step = as<Eight>(axisOf(nodes.steps[v], axis));
            as<Eight>(axisOf(nodes.ahead[v], axis)) = moved + (step + (moved - predicted)) * steps;
        }
}

template <typename Eight>
static void prepareLinks(StripLinks* links, const StripLinkEnds* ends, const EightNumbers* dry,
                         const EightNumbers* inverseMass, const EightNodes* ratios, float smallStepSquared,
                         std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const StripLinkEnds& of = ends[i];
        Eight mass = as<Eight>(inverseMass[of.second].of), ratio = as<Eight>(ratios[of.second].x);
        if (of.turn != 0) turn(mass, of.turn);
        if (of.turn != 0) turn(ratio, of.turn);
        mass = mass + as<Eight>(inverseMass[of.first].of);
        ratio = (ratio + as<Eight>(ratios[of.first].x)) * 0.5f;
        const Eight compliance = 1.0f / (as<Eight>(dry[i].of) * ratio * smallStepSquared);
        for (std::size_t lane = 0; lane < blockWidth; ++lane)
            links[i].share[lane] = 1 / linkDivisor(mass[lane], compliance[lane]);
    }
}

// Eight links of nodes in the same strips.
template <typename Eight>
static inline void solveStraight(EightNodes* moved, const EightNodes* start, const EightNumbers* inverseMass,
                                 const StripLinks& links, const StripLinkEnds& ends) {
    constexpr float tiny = 1e-30f;
    EightNodes &from = moved[ends.first], &to = moved[ends.second];
    const EightNodes &fromStart = start[ends.first], &toStart = start[ends.second];
    const Eight x = (as<Eight>(toStart.x) - as<Eight>(fromStart.x)) + (as<Eight>(to.x) - as<Eight>(from.x));
    const Eight y = (as<Eight>(toStart.y) - as<Eight>(fromStart.y)) + (as<Eight>(to.y) - as<Eight>(from.y));
    const Eight z = (as<Eight>(toStart.z) - as<Eight>(fromStart.z)) + (as<Eight>(to.z) - as<Eight>(from.z));
    Eight length = x * x + y * y + z * z + tiny;
    squareRoot(length);
    const Eight stretch = (1.0f - as<Eight>(links.restLength) / length) * as<Eight>(links.share);
    const Eight forward = stretch * as<Eight>(inverseMass[ends.first].of),
                back = stretch * as<Eight>(inverseMass[ends.second].of);
    as<Eight>(from.x) = as<Eight>(from.x) + x * forward;
    as<Eight>(from.y) = as<Eight>(from.y) + y * forward;
    as<Eight>(from.z) = as<Eight>(from.z) + z * forward;
    as<Eight>(to.x) = as<Eight>(to.x) - x * back;
    as<Eight>(to.y) = as<Eight>(to.y) - y * back;
    as<Eight>(to.z) = as<Eight>(to.z) - z * back;
}

// Eight links to the next strips, or others. Both ends may be in the same vector.
template <typename Eight>
static inline void solveTurned(EightNodes* moved, const EightNodes* start, const EightNumbers* inverseMass,
                               const StripLinks& links, const StripLinkEnds& ends) {
    constexpr float tiny = 1e-30f;
    const int back = static_cast<int>(blockWidth) - ends.turn;
    EightNodes &from = moved[ends.first], &to = moved[ends.second];
    Eight along[3], length = {};
    length = length + tiny;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Eight displacement = as<Eight>(axisOf(to, axis)),
              position = as<Eight>(axisOf(start[ends.second], axis));
        turn(displacement, ends.turn);
        turn(position, ends.turn);
        along[axis] = (position - as<Eight>(axisOf(start[ends.first], axis))) +
                      (displacement - as<Eight>(axisOf(from, axis)));
        length = length + along[axis] * along[axis];
    }
    squareRoot(length);
    Eight stretch = (1.0f - as<Eight>(links.restLength) / length) * as<Eight>(links.share);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Eight& node = as<Eight>(axisOf(from, axis));
        along[axis] = along[axis] * stretch;
        node = node + along[axis] * as<Eight>(inverseMass[ends.first].of);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Eight& node = as<Eight>(axisOf(to, axis));
        turn(along[axis], back);
        node = node - along[axis] * as<Eight>(inverseMass[ends.second].of);
    }
}

template <typename Eight>
static void solveLinks(EightNodes* moved, const EightNodes* start, const EightNumbers* inverseMass,
                       const StripLinks* links, const StripLinkEnds* ends, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        if (ends[i].turn == 0)
            solveStraight<Eight>(moved, start, inverseMass, links[i], ends[i]);
        else
            solveTurned<Eight>(moved, start, inverseMass, links[i], ends[i]);
}

// Numbers of the k-th nodes of eight plates.
template <typename Eight, bool Turned>
static inline void ofNode(Eight& numbers, const float* vector, const StripPlateNodes& of, std::size_t k) {
    numbers = as<Eight>(vector);
    if (Turned && of.turns[k] != 0) turn(numbers, of.turns[k]);
}

// The weighted sums of six nodes along an axis, for three components of the curvature.
template <typename Eight, bool Turned>
static inline void curvature(Eight* components, const EightNodes* nodes, const StripPlateNodes& of,
                             const PlateWeights& weights, std::size_t axis) {
    Eight first;
    ofNode<Eight, Turned>(first, axisOf(nodes[of.vectors[0]], axis), of, 0);
    for (std::size_t m = 0; m < 3; ++m) components[m] = as<Eight>(weights.of[m][0]) * first;
    for (std::size_t k = 1; k < 6; ++k) {
        Eight at;
        ofNode<Eight, Turned>(at, axisOf(nodes[of.vectors[k]], axis), of, k);
        for (std::size_t m = 0; m < 3; ++m) components[m] = components[m] + as<Eight>(weights.of[m][k]) * at;
    }
}

// Moves six nodes along an axis by the remaining correction of the components.
template <typename Eight, bool Turned>
static inline void takeBack(EightNodes* nodes, Eight* components, const EightNumbers* inverseMass,
                            const StripPlates& plates, const StripPlateNodes& of, const PlateWeights& weights,
                            std::size_t axis) {
    for (std::size_t m = 0; m < 3; ++m) components[m] = components[m] * as<Eight>(plates.fraction[m]);
    for (std::size_t k = 0; k < 6; ++k) {
        Eight sum = as<Eight>(weights.of[0][k]) * components[0];
        sum = sum + as<Eight>(weights.of[1][k]) * components[1];
        sum = sum + as<Eight>(weights.of[2][k]) * components[2];
        if (Turned && of.turns[k] != 0) turn(sum, static_cast<int>(blockWidth) - of.turns[k]);
        Eight& node = as<Eight>(axisOf(nodes[of.vectors[k]], axis));
        node = node - sum * as<Eight>(inverseMass[of.vectors[k]].of);
    }
}

template <typename Eight, bool Turned>
static inline void solvePlate(EightNodes* to, const EightNodes* from, const EightNumbers* inverseMass,
                              const StripPlates& plates, const StripPlateNodes& of,
                              const PlateWeights& weights) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Eight components[3];
        curvature<Eight, Turned>(components, from, of, weights, axis);
        takeBack<Eight, Turned>(to, components, inverseMass, plates, of, weights, axis);
    }
}

template <typename Eight>
static void solvePlates(EightNodes* to, const EightNodes* from, const EightNumbers* inverseMass,
                        const StripPlates* plates, const StripPlateNodes* of, const PlateWeights* weights,
                        std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const PlateWeights& own = weights[of[i].weights];
        if (of[i].turned)
            solvePlate<Eight, true>(to, from, inverseMass, plates[i], of[i], own);
        else
            solvePlate<Eight, false>(to, from, inverseMass, plates[i], of[i], own);
    }
}

// Unit normals of the plates' own triangles.
template <typename Eight>
static inline void unitNormal(Eight* normal, const EightNodes* nodes, const StripPlateNodes& of) {
    constexpr float tiny = 1e-30f;
    Eight u[3], v[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Eight corners[3];
        for (std::size_t k = 0; k < 3; ++k)
            ofNode<Eight, true>(corners[k], axisOf(nodes[of.vectors[k]], axis), of, k);
        u[axis] = corners[1] - corners[0];
        v[axis] = corners[2] - corners[0];
    }
    Eight length = {};
    length = length + tiny;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        normal[axis] = u[(axis + 1) % 3] * v[(axis + 2) % 3] - u[(axis + 2) % 3] * v[(axis + 1) % 3];
        length = length + normal[axis] * normal[axis];
    }
    squareRoot(length);
    for (std::size_t axis = 0; axis < 3; ++axis) normal[axis] = normal[axis] / length;
}

// Friction moments, N; friction slides where they exceed the limit.
template <typename Eight>
static inline void slide(Eight* moments, PlateState& state, const Eight* bent, const Eight& stiffness,
                         const Eight& limit) {
    constexpr float tiny = 1e-30f;
    Eight size = {};
    size = size + tiny;
    for (std::size_t m = 0; m < 3; ++m) {
        moments[m] = stiffness * (bent[m] - as<Eight>(state.slid[m]));
        size = size + moments[m] * moments[m];
    }
    squareRoot(size);
    Eight holds = limit / size;
    for (std::size_t lane = 0; lane < blockWidth; ++lane) holds[lane] = holds[lane] < 1 ? holds[lane] : 1;
    for (std::size_t m = 0; m < 3; ++m) {
        // Where friction slides, the curvature of zero friction moment follows.
        as<Eight>(state.slid[m]) = bent[m] - (bent[m] - as<Eight>(state.slid[m])) * holds;
        moments[m] = moments[m] * holds;
    }
}

// Fractions of the components that one sweep corrects; see plateFraction.
template <typename Eight>
static inline void share(StripPlates& plates, const EightNumbers* inverseMass, const StripPlateNodes& of,
                         const PlateWeights& weights, const Eight& compliance, float every) {
    Eight response[3] = {}, all = {};
    for (std::size_t k = 0; k < 6; ++k) {
        Eight mass;
        ofNode<Eight, true>(mass, inverseMass[of.vectors[k]].of, of, k);
        for (std::size_t m = 0; m < 3; ++m)
            response[m] = response[m] + mass * as<Eight>(weights.of[m][k]) * as<Eight>(weights.of[m][k]);
    }
    for (std::size_t m = 0; m < 3; ++m) all = all + response[m];
    for (std::size_t m = 0; m < 3; ++m)
        for (std::size_t lane = 0; lane < blockWidth; ++lane)
            plates.fraction[m][lane] = plateFraction(response[m][lane], all[lane], compliance[lane], every);
}

template <typename Eight>
static inline void meanOfCorners(Eight& mean, const EightNodes* ratios, const StripPlateNodes& of,
                                 std::size_t axis) {
    constexpr float third = 1.0f / 3;
    Eight corners[3];
    for (std::size_t k = 0; k < 3; ++k)
        ofNode<Eight, true>(corners[k], axisOf(ratios[of.vectors[k]], axis), of, k);
    mean = (corners[0] + corners[1] + corners[2]) * third;
}

template <typename Eight>
static void preparePlates(EightNodes* push, StripPlates* plates, PlateState* states,
                          const StripPlateNodes* plateNodes, const PlateWeights* weights,
                          const PlateLaws& laws, const StripNodes& nodes, const EightNodes* ratios,
                          const PlateTimes& times, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const StripPlateNodes& of = plateNodes[i];
        const PlateWeights& own = weights[of.weights];
        Eight rigidity, limit, normal[3], components[3][3], bent[3] = {}, moments[3];
        meanOfCorners(rigidity, ratios, of, 1);
        meanOfCorners(limit, ratios, of, 2);
        rigidity = rigidity * laws.bending;
        limit = limit * laws.frictionLimit;
        const Eight held = rigidity * (1 + laws.frictionStiffness);
        unitNormal(normal, nodes.expected, of);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            curvature<Eight, true>(components[axis], nodes.start, of, own, axis);
            for (std::size_t m = 0; m < 3; ++m) bent[m] = bent[m] + components[axis][m] * normal[axis];
        }
        slide(moments, states[i], bent, rigidity * laws.frictionStiffness, limit);
        const float between = times.smallStep * times.every;
        const Eight compliance = 1.0f / (held * as<Eight>(states[i].area) * (between * between));
        share(plates[i], nodes.inverseMass, of, own, compliance, times.every);
        const Eight elastic = rigidity / held;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t m = 0; m < 3; ++m)
                components[axis][m] = components[axis][m] * elastic + normal[axis] * (moments[m] / held);
            takeBack<Eight, true>(push, components[axis], nodes.inverseMass, plates[i], of, own, axis);
        }
    }
}

template <typename Eight, typename Vector>
static StripKernels kernels() {
    return {read<Eight, Vector>,      write<Eight, Vector>, advance<Eight>,      advanceByFraction<Eight>,
            correctByFraction<Eight>, lookAhead<Eight>,     prepareLinks<Eight>, solveLinks<Eight>,
            preparePlates<Eight>,     solvePlates<Eight>};
}

}  // namespace strip_loops
}  // namespace drench
