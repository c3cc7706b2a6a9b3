// What air and water do to the faces and nodes of a body, in place of Bullet's aero models.
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

// The air and the water around one sheet.
//
// Per face F = -1/2 rho A (C_n |u_n| u_n n + C_t |u_t| u_t), u the velocity of the face against the fluid,
// rho its density. Fluid leaks through the cloth: the pressure is that of the speed which is left after the
// leak, and the leak that of the pressure (Darcy). Where a share of a node is under water, density, velocity
// and permeability are those of the mixture. Water also moves along across the face, pi/4 rho L per area
// (Lamb 1932, "Hydrodynamics": a plate of width L), L the smaller of the root of the sheet's area and 0.1 m
// (assumed: cloth folds at that scale). Per node the water lifts what it displaces: fibre, full pores whether
// water or air is in them, and film.
//
// Drag is taken at the end of the substep. For that each node has an estimate of its acceleration by all else
// than drag and added mass: gravity and buoyancy as they are, and the mean over the last substeps of what
// links, contacts and the application have done. So drag is right where nothing changes, for cloth that falls
// steadily as for cloth that is held; it may stop the relative motion but never reverses it. Added mass acts
// on the same estimate, against each change of the velocity, and on cloth that comes into the water, which
// then shares its momentum with it.
class FluidForces {
  public:
    FluidForces(const RestShape& shape, const Fabric& fabric);

    // What a substep needs.
    struct Around {
        const WetLaws& laws;
        const std::vector<PackedVector>& winds;  // velocity of the air at each node, m/s
        const Submersion& water;
        const Moisture& moisture;
        const SheetMechanics& mechanics;
        const Pose& pose;
        double substep;  // s
    };
    // Adds to the nodes' forces.
    void add(btSoftBody& body, const Around& around);
    // The same as a change of the nodes' velocities, for a world that ignores forces on nodes.
    void push(btSoftBody& body, const Around& around);
    // Forgets the last substep, as the body sleeps.
    void rest() {
        isGoingOn_ = false;
        hasRested_ = true;
    }

    // Whether water lifts a body that has rested otherwise than when it came to rest.
    bool isLiftedOtherwise(const Around& around) const;

    // See SheetPose.
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
    double addedMass_;          // under water, kg/m2
    std::vector<FaceBlock> faces_;
    // Of each node, and a spare one; see PushByFluid. They last until the next substep, which learns from them.
    std::vector<PackedVector> velocities_;
    std::vector<OtherAcceleration> accelerations_;
    std::vector<FluidForce> forces_;
    std::vector<FluidNode> fluid_;
    std::vector<std::size_t> wet_;  // nodes that are in water

    bool isGoingOn_ = false;                    // from the last substep
    bool hasRested_ = false;                    // at some time
    float lastSubstep_ = 0;                     // s
    PackedVector gravity_ = {0, 0, 0, 0};       // m/s2
    PackedVector lastGravity_ = {0, 0, 0, 0};   // of the last substep, m/s2
    std::vector<PackedVector> lastVelocities_;  // as the last substep began, m/s
    // Means over a while under water of the acceleration that was meant and the one that came of it, m/s2.
    std::vector<PackedVector> meantChanges_, changes_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
