// Forces of air and water on the faces and nodes of a body, in place of Bullet's aero models.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/fluid/submersion.h"
#include "bullet/sheet/pose.h"
#include "bullet/sheet/sheet_mechanics.h"
#include "bullet/simd/fluid_kernels.h"
#include "drench/config.h"
#include "drench/fabric.h"
#include "drench/moisture.h"
#include "drench/wet_laws.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

class BulletPass;

// Forces of the air and the water around one sheet.
//
// Per face F = -1/2 rho A (C_n |u_n| u_n n + C_t |u_t| u_t), with u the velocity of the face relative to the
// fluid and rho the density of the fluid. Fluid passes through the cloth: the pressure follows from the
// relative speed minus the speed of the flow through the cloth, and that flow follows from the pressure
// (Darcy). If a fraction of a node is under water, density, velocity and permeability are those of the
// mixture. For motion normal to the face, water has an added mass of pi/4 rho L per area (Lamb 1932,
// "Hydrodynamics": a plate of width L), with L the smaller of the square root of the sheet's area and 0.1 m
// (assumed: cloth folds at that scale). Buoyancy per node is the weight of the displaced water: fibre, full
// pores whether they contain water or air, and film.
//
// Drag is evaluated at the end of the substep. For this each node has an estimate of its acceleration by
// everything except drag and added mass: the present gravity and buoyancy, and the mean effect of links,
// contacts and the application over the last substeps. So drag is accurate in steady states, for cloth that
// falls steadily as for cloth that is held; it may stop the relative motion but never reverses it. The added
// mass uses the same estimate. It resists each change of the velocity, and takes up momentum from cloth that
// enters the water.
class FluidForces {
  public:
    FluidForces(const RestShape& shape, const Fabric& fabric);

    // Input of a substep.
    struct Around {
        const WetLaws& laws;
        const std::vector<PackedVector>& winds;  // velocity of the air at each node, m/s
        const Submersion& water;
        const Moisture& moisture;
        const SheetMechanics& mechanics;
        const Pose& pose;
        double substep;  // s
    };
    // Adds the forces to those of the nodes.
    void add(btSoftBody& body, const Around& around);
    // Changes the velocities of the nodes instead, for a world that ignores nodal forces.
    void push(btSoftBody& body, const Around& around);
    // Resets the estimates, because the body sleeps.
    void rest() {
        isGoingOn_ = false;
        hasRested_ = true;
    }

    // Whether buoyancy on a sleeping body differs from that at the time when it fell asleep.
    bool isLiftedOtherwise(const Around& around) const;

    // See SheetPose::floatingFraction.
    double floatingFraction() const { return floatingFraction_; }

  private:
    friend class BulletPass;
    void state(BulletPass& pass);

    void evaluate(const btSoftBody& body, const Around& around);
    void begin(const btSoftBody& body, const Around& around);
    void gather(const Around& around);
    Eigen::Array4f answered(std::size_t node, const Eigen::Array4f& meant, const Eigen::Array4f& change);
    void gatherWater(const Around& around);
    void immerse(std::size_t node, float fraction, float displacedOverMass, const Around& around);
    float maxDisplaced(std::size_t node, const Around& around) const;
    float fractionAtEnd(std::size_t node, float displacedOverMass, const Around& around) const;
    void answerLift(std::size_t node, float lifted);
    void lift(const Around& around);

    std::vector<float> areas_;  // of the nodes, m2
    double fibrePerArea_;       // water that the fibre displaces, kg/m2
    double floatingFraction_;   // see SheetPose
    double waterPermeability_;  // m/(s Pa)
    double totalArea_;          // m2
    double addedMass_;          // added mass under water, kg/m2
    std::vector<FaceBlock> faces_;
    // For each node, and a spare one; see PushByFluid. They are kept until the next substep, which uses them
    // for its estimates.
    std::vector<PackedVector> velocities_;
    std::vector<OtherAcceleration> accelerations_;
    std::vector<FluidForce> forces_;
    std::vector<FluidNode> fluid_;
    std::vector<std::size_t> wet_;  // nodes under water

    bool isGoingOn_ = false;                    // whether there is a last substep
    bool hasRested_ = false;                    // whether the body has slept since the start
    float lastSubstep_ = 0;                     // s
    PackedVector gravity_ = {0, 0, 0, 0};       // m/s2
    PackedVector lastGravity_ = {0, 0, 0, 0};   // of the last substep, m/s2
    std::vector<PackedVector> lastVelocities_;  // at the start of the last substep, m/s
    // Moving averages, for nodes under water, of the expected and of the actual acceleration, m/s2.
    std::vector<PackedVector> meantChanges_, changes_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
