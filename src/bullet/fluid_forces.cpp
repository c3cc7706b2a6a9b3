#include "fluid_forces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "drench/source.h"
#include "drench/water.h"
#include "independent_blocks.h"
#include "vectors.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

/// Under water across a sheet of that area, kg/m2; see FluidForces.
double addedMassOf(double area) {
    constexpr double widest = 0.1;  // m
    constexpr double quarterOfPi = 0.785398163397448;
    return quarterOfPi * waterDensity * std::min(std::sqrt(area), widest);
}

MovingNode sum(const MovingNode& a, const MovingNode& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z, 0};
}

MovingNode difference(const MovingNode& a, const MovingNode& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z, 0};
}

MovingNode scaled(const MovingNode& a, float by) {
    return {a.x * by, a.y * by, a.z * by, 0};
}

/// Mean of two, the second counting `share`.
MovingNode mixed(const MovingNode& a, const MovingNode& b, float share) {
    return sum(a, scaled(difference(b, a), share));
}

float dot(const MovingNode& a, const MovingNode& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

MovingNode packed(const Eigen::Vector3d& v) {
    return {float(v.x()), float(v.y()), float(v.z()), 0};
}

float sizeOf(const MovingNode& a) {
    return std::abs(a.x) + std::abs(a.y) + std::abs(a.z);  // not finite where one of them is not
}

MovingNode limited(const MovingNode& a, float most) {
    return {std::clamp(a.x, -most, most), std::clamp(a.y, -most, most), std::clamp(a.z, -most, most), 0};
}

}  // namespace

FluidForces::FluidForces(const RestShape& shape, const Fabric& fabric)
    : areas_(shape.nodeAreas.begin(), shape.nodeAreas.end()),
      fibrePerArea_(waterDensity * fabric.arealDensity / fabric.fibreDensity),
      // Across the cloth as along it (assumed), whose two directions count alike.
      waterPermeability_(std::sqrt(fabric.permeabilityWarp * fabric.permeabilityWeft) /
                         (waterViscosity * fabric.thickness)),
      addedMass_(addedMassOf(std::accumulate(shape.nodeAreas.begin(), shape.nodeAreas.end(), 0.0))),
      velocities_(shape.nodeAreas.size() + 1, MovingNode{0, 0, 0, 0}),
      accelerations_(velocities_),
      forces_(velocities_),
      fluid_(velocities_.size(), FluidNode{0, 0, 0, 0}),
      weights_(velocities_),
      lastWeights_(velocities_),
      others_(velocities_),
      lastVelocities_(velocities_),
      explained_(velocities_) {
    const auto spare = static_cast<std::int32_t>(areas_.size());
    for (const IndependentBlock& chosen : independentBlocks(shape.triangles, areas_.size())) {
        FaceBlock& block = faces_.emplace_back();
        for (std::size_t lane = 0; lane < blockWidth; ++lane) {
            const bool isUsed = chosen[lane] >= 0;
            const auto face = static_cast<std::size_t>(isUsed ? chosen[lane] : 0);
            for (std::size_t corner = 0; corner < 3; ++corner)
                block.nodes[corner][lane] = isUsed ? shape.triangles[face][corner] : spare;
            block.restArea[lane] = isUsed ? float(shape.triangleAreas[face]) : 0;
        }
    }
}

void FluidForces::add(btSoftBody& body, const Around& around) {
    evaluate(body, around);
    for (int n = 0; n < body.m_nodes.size(); ++n)
        body.m_nodes[n].m_f += vectorOf(forces_[static_cast<std::size_t>(n)]);
}

void FluidForces::push(btSoftBody& body, const Around& around) {
    evaluate(body, around);
    for (int n = 0; n < body.m_nodes.size(); ++n)
        body.m_nodes[n].m_v += vectorOf(forces_[static_cast<std::size_t>(n)]) *
                               (body.m_nodes[n].m_im * btScalar(around.substep));
}

void FluidForces::evaluate(const btSoftBody& body, const Around& around) {
    gatherAir(around);
    gatherWater(around);
    for (FluidNode& node : fluid_)
        node.shareBefore = isGoingOn_ ? std::min(node.shareBefore, node.share) : node.share;
    estimate(body, around);
    const AirDrag drag = around.laws.drag(0);  // of its members only the permeability depends on the water
    bestKernels().pushByFluid(forces_.data(), faces_.data(), around.pose.places.data(), velocities_.data(),
                              accelerations_.data(), fluid_.data(),
                              {float(airDensity), float(waterDensity), float(0.5 * drag.normal),
                               float(0.5 * drag.tangential), float(addedMass_), float(around.substep)},
                              faces_.size());
    // Also of pins, at which the force comes to nothing since something answers it.
    for (std::size_t n = 0; n < areas_.size(); ++n) {
        const auto mass = float(around.mechanics.masses[n]);
        explained_[n] = sum(weights_[n], scaled(forces_[n], mass > 0 ? 1 / mass : 0));
        // Of a substep that comes to nothing sensible nothing is learnt.
        constexpr float absurd = 1e6f;  // m/s2
        if (!(sizeOf(explained_[n]) < absurd)) isGoingOn_ = false;
    }
    lift(around);
}

void FluidForces::gatherAir(const Around& around) {
    const AirDrag dry = around.laws.drag(0), wet = around.laws.drag(1);
    const auto permeability = float(dry.permeability),
               loss = float(dry.permeability - wet.permeability);  // linear in the saturation
    const Eigen::Vector3d down = -around.pose.gravity * around.pose.up;
    const MovingNode gravity = packed(down);
    weights_.swap(lastWeights_);
    for (std::size_t n = 0; n < areas_.size(); ++n) {
        const float massPerArea = areas_[n] > 0 ? float(around.mechanics.masses[n]) / areas_[n] : 0;
        fluid_[n] = {0, fluid_[n].share, massPerArea,
                     permeability - loss * float(around.mechanics.saturations[n])};
        velocities_[n] = difference(around.pose.speeds[n], around.winds[n]);
        weights_[n] = gravity;
        forces_[n] = {0, 0, 0, 0};
    }
}

void FluidForces::gatherWater(const Around& around) {
    for (const std::size_t n : around.water.nodes()) {
        const auto mass = float(around.mechanics.masses[n]);
        if (!(mass > 0) || !(areas_[n] > 0)) continue;
        const float displaced = displacedAtMost(n, around), share = shareAtEnd(n, displaced / mass, around);
        const float inWater = share * float(waterDensity), inAir = (1 - share) * float(airDensity);
        const MovingNode moving =
            mixed(around.winds[n], around.water.velocity(n), inWater / (inWater + inAir));
        FluidNode& fluid = fluid_[n];
        fluid.share = share;
        fluid.permeability += (float(waterPermeability_) - fluid.permeability) * share;
        velocities_[n] = difference(around.pose.speeds[n], moving);
        weights_[n] = scaled(weights_[n], 1 - displaced * share / mass);
    }
}

/// Water whose place a node takes when all of it is under, kg.
float FluidForces::displacedAtMost(std::size_t node, const Around& around) const {
    return float(double(areas_[node]) * fibrePerArea_ + around.moisture.poreCapacity(node) +
                 around.moisture.filmMass()[node]);
}

/// Share of a node under water at the end of the substep, to first order: a lift that is as strong as where the
/// node has been would make what floats bob ever higher.
float FluidForces::shareAtEnd(std::size_t node, float displacedOverMass, const Around& around) const {
    const auto dt = float(around.substep), gravity = float(around.pose.gravity);
    const MovingNode up = packed(around.pose.up);
    const float depth = around.water.depth(node) -
                        dot(difference(around.pose.speeds[node], around.water.velocity(node)), up) * dt;
    const double share = shareUnderWater(double(depth));
    if (share == 0 || share == 1) return float(share);
    constexpr double apart = 1e-4;  // m
    const double slope =
        (shareUnderWater(double(depth) + apart) - shareUnderWater(double(depth) - apart)) / (2 * apart);
    const float perLift = float(slope) * dt * dt;
    const float falling = gravity - dot(others_[node], up);
    return std::clamp((float(share) + perLift * falling) / (1 + perLift * gravity * displacedOverMass), 0.0f,
                      1.0f);
}

/// The estimate lags behind. A mean over several substeps keeps that from driving what vibrates from one
/// substep to the next: 0.2 does in air, up to drag that would stop the cloth in a third of a substep. In
/// water, which goes along and slows vibrations, 0.5 does, and a wrong estimate is sooner forgotten.
void FluidForces::estimate(const btSoftBody& body, const Around& around) {
    if (isGoingOn_) {
        constexpr float newestInAir = 0.2f, newestInWater = 0.5f;  // shares in the mean
        // Blows much harder than what the fluid does say nothing of the next substep, m/s2 (assumed).
        const float hardest = std::max(100.0f, 2 * float(around.pose.gravity));
        const float perSecond = 1 / lastSubstep_;
        for (std::size_t n = 0; n < areas_.size(); ++n) {
            const MovingNode found = difference(
                scaled(difference(around.pose.speeds[n], lastVelocities_[n]), perSecond), explained_[n]);
            const float newest = newestInAir + (newestInWater - newestInAir) * fluid_[n].share;
            others_[n] = mixed(others_[n], limited(found, hardest + 2 * sizeOf(explained_[n])), newest);
        }
        for (const std::size_t n : around.water.nodes()) answerLift(n);
    } else {
        begin(body);
    }
    for (std::size_t n = 0; n < areas_.size(); ++n) {
        accelerations_[n] = sum(weights_[n], others_[n]);
        lastVelocities_[n] = around.pose.speeds[n];
    }
    lastSubstep_ = float(around.substep);
    isGoingOn_ = true;
}

/// What holds a node answers any change of its weight at once, as far as it has held it: without knowing that,
/// water that goes along would.
void FluidForces::answerLift(std::size_t node) {
    constexpr float nothing = 0.01f;  // m2/s4
    const MovingNode &others = others_[node], &last = lastWeights_[node];
    const float held = std::clamp((nothing - dot(others, last)) / (nothing + dot(last, last)), 0.0f, 1.0f);
    others_[node] = difference(others, scaled(difference(weights_[node], last), held));
}

/// A sheet that is held somewhere, or has slept, begins in balance; any other as falling.
void FluidForces::begin(const btSoftBody& body) {
    bool isHeld = hasRested_ || body.m_anchors.size() > 0;
    for (int n = 0; !isHeld && n < body.m_nodes.size(); ++n) isHeld = !(body.m_nodes[n].m_im > 0);
    for (std::size_t n = 0; n < areas_.size(); ++n) others_[n] = scaled(weights_[n], isHeld ? -1.0f : 0.0f);
}

void FluidForces::lift(const Around& around) {
    const Eigen::Vector3d up = around.pose.gravity * around.pose.up;
    for (const std::size_t n : around.water.nodes())
        shift(forces_[n], toBullet(up * double(fluid_[n].share * displacedAtMost(n, around))));
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
