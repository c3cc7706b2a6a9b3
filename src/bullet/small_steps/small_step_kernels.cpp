#include "bullet/small_steps/small_step_kernels.h"

#include <cmath>

namespace drench {

#if defined(__GNUC__)
namespace baseline {
#include "bullet/small_steps/small_step_kernels_wide.inc"
}  // namespace baseline
#endif

#if defined(DRENCH_HAS_AVX2_KERNELS)
const SmallStepKernels& avx2Kernels();
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

void addTo(MovingNode& node, float x, float y, float z, float by) {
    node.x += x * by;
    node.y += y * by;
    node.z += z * by;
}

/// @return twice the area
float normalOf(float* normal, const MovingNode& a, const MovingNode& b, const MovingNode& c) {
    constexpr float tiny = 1e-30f;
    const float u[3] = {b.x - a.x, b.y - a.y, b.z - a.z}, v[3] = {c.x - a.x, c.y - a.y, c.z - a.z};
    for (std::size_t axis = 0; axis < 3; ++axis)
        normal[axis] = u[(axis + 1) % 3] * v[(axis + 2) % 3] - u[(axis + 2) % 3] * v[(axis + 1) % 3];
    const float length =
        std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2] + tiny);
    for (std::size_t axis = 0; axis < 3; ++axis) normal[axis] /= length;
    return length;
}

void meanOf(float* mean, const MovingNode& a, const MovingNode& b, const MovingNode& c) {
    constexpr float third = 1.0f / 3;
    mean[0] = (a.x + b.x + c.x) * third;
    mean[1] = (a.y + b.y + c.y) * third;
    mean[2] = (a.z + b.z + c.z) * third;
}

/// Force of the fluid on a third of a face; see the wide form.
void pushFace(MovingNode* forces, const FaceBlock& block, const MovingNode* positions,
              const MovingNode* velocities, const MovingNode* accelerations, const FluidNode* fluid,
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
        mean.share += fluid[node].share * third;
        mean.shareBefore += fluid[node].shareBefore * third;
        mean.massPerArea += fluid[node].massPerArea * third;
        mean.permeability += fluid[node].permeability * third;
    }
    const float mass = mean.massPerArea * block.restArea[lane], most = laws.addedMass * block.restArea[lane],
                added = mean.share * most, both = mass + added, before = mass + mean.shareBefore * most;
    const float density = laws.airDensity + (laws.waterDensity - laws.airDensity) * mean.share;
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
    const float share =
        2 * mass / (mass + std::sqrt(mass * mass + 4 * mass * shear * laws.substep * speedAlong) + tiny);
    const float along = shear * speedAlong * share * share;
    float force[3];
    for (std::size_t axis = 0; axis < 3; ++axis)
        force[axis] = -third * (normal[axis] * across + next[axis] * along);
    for (const std::int32_t node : nodes) addTo(forces[node], force[0], force[1], force[2], 1);
}

void pushByFluid(MovingNode* forces, const FaceBlock* blocks, const MovingNode* positions,
                 const MovingNode* velocities, const MovingNode* accelerations, const FluidNode* fluid,
                 const FluidLaws& laws, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t lane = 0; lane < blockWidth; ++lane)
            pushFace(forces, blocks[i], positions, velocities, accelerations, fluid, laws, lane);
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
            block.firstShare[lane] = from.inverseMass / constant;
            block.secondShare[lane] = to.inverseMass / constant;
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
            addTo(from, x, y, z, stretch * block.firstShare[lane]);
            addTo(to, x, y, z, -stretch * block.secondShare[lane]);
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

/// @param masses  where the nodes' inverse masses are
void takeBack(MovingNode* nodes, const MovingNode* masses, const Components& components,
              const PlateBlock& block, const PlateWeights& weights, std::size_t lane) {
    for (std::size_t k = 0; k < 6; ++k) {
        const std::int32_t node = block.nodes[k][lane];
        float sum[3] = {};
        for (std::size_t m = 0; m < 3; ++m)
            for (std::size_t axis = 0; axis < 3; ++axis)
                sum[axis] += weights.of[m][k][lane] * block.share[m][lane] * components.of[m][axis];
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
        block.share[m][lane] = plateShare(response[m], all, compliance, every);
}

float meanOfCorners(const NodeRatios* ratios, float NodeRatios::*ratio, const PlateBlock& block,
                    std::size_t lane) {
    return (ratios[block.nodes[0][lane]].*ratio + ratios[block.nodes[1][lane]].*ratio +
            ratios[block.nodes[2][lane]].*ratio) /
           3;
}

void preparePlate(MovingNode* push, PlateBlock& block, PlateState& state, const PlateWeights& weights,
                  const PlateLaws& laws, const MovingNode* start, const NodeRatios* ratios,
                  const PlateTimes& times, std::size_t lane) {
    const float rigidity = laws.bending * meanOfCorners(ratios, &NodeRatios::bending, block, lane);
    const float limit = laws.frictionLimit * meanOfCorners(ratios, &NodeRatios::bendingFriction, block, lane);
    const float held = rigidity * (1 + laws.frictionStiffness);

    float normal[3], bent[3], moments[3];
    normalOf(normal, start[block.nodes[0][lane]], start[block.nodes[1][lane]], start[block.nodes[2][lane]]);
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
                   const PlateLaws& laws, const MovingNode* start, const NodeRatios* ratios,
                   const PlateTimes& times, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t lane = 0; lane < blockWidth; ++lane)
            preparePlate(push, blocks[i], states[i], weights[blocks[i].weights], laws, start, ratios, times,
                         lane);
}

}  // namespace

const SmallStepKernels& scalarKernels() {
    static const SmallStepKernels kernels = {"scalar",   advance,       pushByFluid, prepareLinks,
                                             solveLinks, preparePlates, solvePlates};
    return kernels;
}

#if defined(__GNUC__)

namespace {

const SmallStepKernels& baselineKernels() {
    static const SmallStepKernels kernels = {
        "baseline vectors",   baseline::advance,       baseline::pushByFluid, baseline::prepareLinks,
        baseline::solveLinks, baseline::preparePlates, baseline::solvePlates};
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
