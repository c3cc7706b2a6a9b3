#include "bullet/fluid/fluid_forces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bullet/simd/independent_blocks.h"
#include "bullet/simd/node_arrays.h"
#include "bullet/world/vectors.h"
#include "drench/source.h"
#include "drench/water.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// Added mass of a sheet of that area under water, kg/m2; see FluidForces.
double addedMassOf(double area) {
    constexpr double widest = 0.1;  // m
    constexpr double quarterOfPi = 0.785398163397448;
    return quarterOfPi * waterDensity * std::min(std::sqrt(area), widest);
}

float dot(const Eigen::Array4f& a, const Eigen::Array4f& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

float sizeOf(const Eigen::Array4f& a) {
    return std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]);  // not finite if one component is not
}

}  // namespace

FluidForces::FluidForces(const RestShape& shape, const Fabric& fabric)
    : areas_(shape.nodeAreas.begin(), shape.nodeAreas.end()),
      fibrePerArea_(waterDensity * fabric.arealDensity / fabric.fibreDensity),
      floatingFraction_(fabric.arealDensity / (fibrePerArea_ + fabric.poreCapacity())),
      // Permeability through the cloth, equal to that along it (assumed), as the mean of both directions.
      waterPermeability_(std::sqrt(fabric.permeabilityWarp * fabric.permeabilityWeft) /
                         (waterViscosity * fabric.thickness)),
      totalArea_(std::accumulate(shape.nodeAreas.begin(), shape.nodeAreas.end(), 0.0)),
      addedMass_(addedMassOf(totalArea_)),
      velocities_(shape.nodeAreas.size() + 1, PackedVector{0, 0, 0, 0}),
      accelerations_(velocities_.size(), OtherAcceleration{0, 0, 0, 0}),
      forces_(velocities_.size(), FluidForce{0, 0, 0, 0}),
      fluid_(velocities_.size(), FluidNode{0, 0, 0, 0}),
      lastVelocities_(velocities_),
      meantChanges_(velocities_),
      changes_(velocities_) {
    wet_.reserve(areas_.size());
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

bool FluidForces::isLiftedOtherwise(const Around& around) const {
    constexpr double noticeable = 0.05;  // of the sheet
    double changed = 0;
    for (const std::size_t n : around.water.nodes())
        changed += double(areas_[n]) *
                   std::abs(submergedFraction(double(around.water.depth(n))) - double(fluid_[n].fraction));
    for (const std::size_t n : wet_)
        if (!around.water.knows(n)) changed += double(areas_[n] * fluid_[n].fraction);
    return changed > noticeable * totalArea_;
}

void FluidForces::evaluate(const btSoftBody& body, const Around& around) {
    lastGravity_ = gravity_;
    gravity_ = packed(-around.pose.gravity * around.pose.up);
    if (!isGoingOn_) begin(body, around);
    gather(around);
    gatherWater(around);
    const AirDrag drag = around.laws.drag(0);  // only the permeability depends on the water
    bestPushByFluid()(forces_.data(), faces_.data(), around.pose.relativePositions.data(), velocities_.data(),
                      accelerations_.data(), fluid_.data(),
                      {float(airDensity), float(waterDensity), float(0.5 * drag.normal),
                       float(0.5 * drag.tangential), float(addedMass_), float(around.substep)},
                      faces_.size());
    lift(around);
    lastSubstep_ = float(around.substep);
    isGoingOn_ = true;
}

// Initial estimate: a sheet that is held at some node, or has slept, is in equilibrium; any other sheet is in
// free fall. Sets the values of a previous substep from which `gather` derives this estimate.
void FluidForces::begin(const btSoftBody& body, const Around& around) {
    bool isHeld = hasRested_ || body.m_anchors.size() > 0;
    for (int n = 0; !isHeld && n < body.m_nodes.size(); ++n) isHeld = !(body.m_nodes[n].m_im > 0);
    const OtherAcceleration none = {0, 0, 0, 0}, falling = {gravity_.x, gravity_.y, gravity_.z, 0};
    const FluidForce balance = {0, 0, 0, 0}, weight = {-gravity_.x, -gravity_.y, -gravity_.z, 1};
    for (std::size_t n = 0; n < areas_.size(); ++n) {
        accelerations_[n] = isHeld ? none : falling;
        forces_[n] = isHeld ? balance : weight;
        lastVelocities_[n] = around.pose.speeds[n];
        meantChanges_[n] = changes_[n] = PackedVector{0, 0, 0, 0};
    }
    lastGravity_ = gravity_;
    lastSubstep_ = float(around.substep);
}

// Updates the estimates of each node from the last substep, and its properties in air, in one pass over all
// arrays.
//
// The estimate lags behind. Averaging over several substeps prevents it from exciting vibrations from one
// substep to the next: a weight of 0.2 suffices in air, up to a drag that would stop the cloth in a third of
// a substep. In water, whose added mass slows vibrations, 0.5 suffices, and a wrong estimate is corrected
// sooner.
void FluidForces::gather(const Around& around) {
    constexpr float newestInAir = 0.2f, newestInWater = 0.5f;  // weights of the newest value in the mean
    constexpr float absurd = 1e6f;  // m/s2; a substep with larger values is ignored
    // Impacts much harder than the forces of the fluid do not predict the next substep, m/s2 (assumed).
    const float hardest = std::max(100.0f, 2 * float(around.pose.gravity)), perSecond = 1 / lastSubstep_;
    const Eigen::Array4f gravity = arrayOf(gravity_), lastGravity = arrayOf(lastGravity_);
    const AirDrag dry = around.laws.drag(0), wet = around.laws.drag(1);
    const auto permeability = float(dry.permeability),
               loss = float(dry.permeability - wet.permeability);  // linear in the saturation
    for (std::size_t n = 0; n < areas_.size(); ++n) {
        OtherAcceleration& acceleration = accelerations_[n];
        FluidForce& force = forces_[n];
        FluidNode& fluid = fluid_[n];
        const Eigen::Array4f speed = arrayOf(around.pose.speeds[n]),
                             change = (speed - arrayOf(lastVelocities_[n])) * perSecond,
                             explained = lastGravity + arrayOf(force) * force.inverseMass;
        Eigen::Array4f others = arrayOf(acceleration) - lastGravity * (1 - acceleration.lifted);
        const Eigen::Array4f meant = explained + others;
        const float size = sizeOf(explained), max = hardest + 2 * size;
        if (size < absurd)
            others += ((change - explained).min(max).max(-max) - others) *
                      (newestInAir + (newestInWater - newestInAir) * fluid.fraction);
        if (fluid.fraction > 0) others -= answered(n, meant, change);
        const float mass = float(around.mechanics.masses[n]);
        const Eigen::Array4f sum = gravity + others;
        acceleration = {sum[0], sum[1], sum[2], acceleration.lifted};
        force = {0, 0, 0, mass > 0 ? 1 / mass : 0};
        fluid.massPerArea = areas_[n] > 0 ? mass / areas_[n] : 0;
        fluid.permeability = permeability - loss * float(around.mechanics.saturations[n]);
        velocities_[n] = nodeOf(speed - arrayOf(around.winds[n]));
        lastVelocities_[n] = around.pose.speeds[n];
    }
}

// Part of a node's estimated acceleration that is cancelled by whatever holds the node. The force of the
// added mass depends on the estimate, and what holds a node responds to that force. The two could confirm
// each other for long: cloth that lands would be weightless for seconds. So a node whose mean acceleration
// does not follow the mean expected one counts as held.
Eigen::Array4f FluidForces::answered(std::size_t node, const Eigen::Array4f& meant,
                                     const Eigen::Array4f& change) {
    constexpr float awhile = 0.1f, tiny = 1e-12f;  // s (assumed); m2/s4
    const float towards = lastSubstep_ / (lastSubstep_ + awhile);
    PackedVector &meanMeant = meantChanges_[node], &meanChange = changes_[node];
    meanMeant = nodeOf(arrayOf(meanMeant) + (meant - arrayOf(meanMeant)) * towards);
    meanChange = nodeOf(arrayOf(meanChange) + (change - arrayOf(meanChange)) * towards);
    // Only the component along the estimate; vibrations in other directions are not relevant to it.
    const auto estimate = arrayOf(accelerations_[node]);
    const float meantAlong = dot(arrayOf(meanMeant), estimate),
                follows = dot(arrayOf(meanChange), estimate) / (meantAlong + tiny);
    if (!(meantAlong > 0 && follows < 0.5f)) return Eigen::Array4f::Zero();
    // The force changes with the estimate in proportion to the added mass over the mass.
    const FluidNode& fluid = fluid_[node];
    const float perMeant = 1 + float(addedMass_) * fluid.fraction / fluid.massPerArea;
    const float wrong = perMeant * meantAlong / (dot(estimate, estimate) + tiny);
    return estimate * (towards * std::min(1.0f, 1 - 2 * follows) * std::min(1.0f, wrong));
}

void FluidForces::gatherWater(const Around& around) {
    for (const std::size_t n : wet_)
        if (!around.water.knows(n)) immerse(n, 0, 0, around);
    wet_.clear();
    for (const std::size_t n : around.water.nodes()) {
        const auto mass = float(around.mechanics.masses[n]);
        if (!(mass > 0) || !(areas_[n] > 0)) continue;
        const float displacedOverMass = maxDisplaced(n, around) / mass;
        immerse(n, fractionAtEnd(n, displacedOverMass, around), displacedOverMass, around);
        wet_.push_back(n);
    }
}

// Submerges a fraction of a node, as `gather` has left it.
void FluidForces::immerse(std::size_t node, float fraction, float displacedOverMass, const Around& around) {
    FluidNode& fluid = fluid_[node];
    fluid.fractionBefore = isGoingOn_ ? std::min(fluid.fraction, fraction) : fraction;
    fluid.fraction = fraction;
    answerLift(node, fraction * displacedOverMass);
    if (!(fraction > 0)) {
        meantChanges_[node] = changes_[node] = PackedVector{0, 0, 0, 0};
        return;
    }
    const float inWater = fraction * float(waterDensity), inAir = (1 - fraction) * float(airDensity);
    const Eigen::Array4f wind = arrayOf(around.winds[node]), stream = arrayOf(around.water.velocity(node)),
                         moving = wind + (stream - wind) * (inWater / (inWater + inAir));
    velocities_[node] = nodeOf(arrayOf(around.pose.speeds[node]) - moving);
    fluid.permeability += (float(waterPermeability_) - fluid.permeability) * fraction;
}

// Mass of water that a completely submerged node displaces, kg.
float FluidForces::maxDisplaced(std::size_t node, const Around& around) const {
    return float(double(areas_[node]) * fibrePerArea_ + around.moisture.poreCapacity(node) +
                 around.moisture.filmMass()[node]);
}

// Submerged fraction of a node at the end of the substep, to first order. With the fraction at the start of
// the substep, floating bodies would bob ever higher.
float FluidForces::fractionAtEnd(std::size_t node, float displacedOverMass, const Around& around) const {
    const auto dt = float(around.substep), gravity = float(around.pose.gravity);
    const PackedVector up = packed(around.pose.up);
    const float depth =
        around.water.depth(node) -
        dot(arrayOf(around.pose.speeds[node]) - arrayOf(around.water.velocity(node)), arrayOf(up)) * dt;
    const double fraction = submergedFraction(double(depth));
    if (fraction == 0 || fraction == 1) return float(fraction);
    constexpr double apart = 1e-4;  // m
    const double slope =
        (submergedFraction(double(depth) + apart) - submergedFraction(double(depth) - apart)) / (2 * apart);
    const float perLift = float(slope) * dt * dt;
    const float falling = -dot(arrayOf(accelerations_[node]), arrayOf(up));  // without buoyancy
    return std::clamp((float(fraction) + perLift * falling) / (1 + perLift * gravity * displacedOverMass),
                      0.0f, 1.0f);
}

// Whatever holds a node compensates a change of its weight immediately, as far as it has held the node
// before. The estimate must include this, because the added mass acts on it.
void FluidForces::answerLift(std::size_t node, float lifted) {
    constexpr float nothing = 0.01f;  // m2/s4
    OtherAcceleration& acceleration = accelerations_[node];
    const Eigen::Array4f weight = arrayOf(gravity_) * (1 - lifted),
                         last = arrayOf(lastGravity_) * (1 - acceleration.lifted),
                         others = arrayOf(acceleration) - arrayOf(gravity_);
    const float held = std::clamp((nothing - dot(others, last)) / (nothing + dot(last, last)), 0.0f, 1.0f);
    const Eigen::Array4f sum = weight + others - (weight - last) * held;
    acceleration = {sum[0], sum[1], sum[2], lifted};
}

void FluidForces::lift(const Around& around) {
    for (const std::size_t n : wet_) {
        const float mass = float(around.mechanics.masses[n]) * accelerations_[n].lifted;
        FluidForce& force = forces_[n];
        force = {force.x - gravity_.x * mass, force.y - gravity_.y * mass, force.z - gravity_.z * mass,
                 force.inverseMass};
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
