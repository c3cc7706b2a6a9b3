// The springs and bending plates of one sheet, as a force of Bullet's deformable world.
#pragma once

#include <BulletSoftBody/btDeformableLagrangianForce.h>

#include <array>
#include <vector>

#include "bullet/sheet/sheet_mechanics.h"
#include "cloth/plate_bending.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Stretch and shear along the links, k (length - rest length) each, and bending by the plates of
// plate_bending.h. The bending links of the body are not used, because a spring across two cells has no
// stiffness at small angles.
//
// The differential must be positive for the implicit solver. So it omits the negative transverse stiffness of
// compressed springs (which buckle); that of the plates is constant and never negative.
//
// Adds itself to the solver's list of forces instead of using the world's addForce, which would assign the
// body of a second force of the same type to the first one. It leaves the list as soon as its body has left
// the world.
class WetSpringForce final : public btDeformableLagrangianForce {
  public:
    using List = btAlignedObjectArray<btDeformableLagrangianForce*>;

    // @param mechanics  outlives this
    explicit WetSpringForce(const SheetMechanics& mechanics);
    ~WetSpringForce() override = default;
    WetSpringForce(const WetSpringForce&) = delete;
    WetSpringForce& operator=(const WetSpringForce&) = delete;

    // Takes part in the steps of the solver that owns this list, acting on `body`. May be called again at any
    // time.
    void join(List& list, const btAlignedObjectArray<btSoftBody::Node*>& nodes, btSoftBody& body);
    bool hasJoined() const { return list_ != nullptr; }
    // Stops taking part. @pre the solver exists
    void leave();
    // Has no effect from now on; if it is still in a list, it leaves it at the next step of that solver.
    void release();

    // Reads the stiffness of this substep from the mechanics.
    void update();

    // Upper bound of the squared angular frequencies of the sheet, 1/s2, in any pose and without pins, for a
    // stiffness of `stretchRatio` and `bendingRatio` times that of the dry cloth (Gershgorin).
    // @param masses  of its nodes, kg
    double largestSquaredFrequency(const std::vector<double>& masses, double stretchRatio,
                                   double bendingRatio) const;

    btDeformableLagrangianForceType getForceType() override;
    void addScaledForces(btScalar scale, TVStack& force) override;
    void addScaledExplicitForce(btScalar scale, TVStack& force) override;
    void addScaledElasticForceDifferential(btScalar scale, const TVStack& dx, TVStack& df) override;
    void addScaledHessian(btScalar scale) override;
    double totalElasticEnergy(btScalar dt) override;
    void reinitialize(bool nodeUpdated) override;

    // The sheet has no damping of its own.
    void addScaledDampingForce(btScalar, TVStack&) override {}
    void addScaledDampingForceDifferential(btScalar, const TVStack&, TVStack&) override {}
    void buildDampingForceDifferentialDiagonal(btScalar, TVStack&) override {}

  private:
    struct Spring {
        std::array<int, 2> nodes;
        std::size_t link;
        btScalar restLength;
        btScalar stiffness = 0;                    // N/m
        btVector3 direction = btVector3(0, 0, 0);  // at the last gather
        btScalar tension = 0;                      // N
        btScalar acrossStiffness = 0;              // N/m, never negative
    };
    struct Plate {
        int count = 0;  // number of its nodes
        std::array<int, 6> nodes;
        std::array<std::array<btScalar, 6>, 3> weights;
        std::array<std::size_t, 3> corners;
        double dryStiffness;     // B area, N m3
        btScalar stiffness = 0;  // N m3

        // Weighted sum of node positions relative to the first node: the weights of a curvature add up to 0.
        template <typename Position>
        btVector3 curvature(std::size_t which, const Position& position) const;
    };

    bool pulls() const;
    void gather(bool predicted);
    template <typename Position>
    void addPlateForces(btScalar scale, const Position& position, TVStack& force) const;
    void addForces(btScalar scale, TVStack& force) const;

    const SheetMechanics& mechanics_;
    std::vector<Spring> springs_;
    std::vector<Plate> plates_;
    std::vector<btVector3> positions_;  // at the last gather
    List* list_ = nullptr;              // the list that contains this; null once the body has left the world
    int first_ = 0;                     // index of the body's first node among all of the world's
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
