// The springs and plates of one sheet, as a force of Bullet's deformable world.
#pragma once

#include <BulletSoftBody/btDeformableLagrangianForce.h>

#include <array>
#include <vector>

#include "bullet/sheet/sheet_mechanics.h"
#include "cloth/plate_bending.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Stretch and shear along the links, k (length - rest) each, and bending as the plates of plate_bending.h.
// The body's bending links are left out, as a spring across two cells is no bending at small angles.
//
// The differential, which the implicit solver wants positive, leaves out what a shortened spring would do
// across itself (it buckles); that of the plates is constant and never negative.
//
// Joins the solver's list of forces itself rather than through the world's addForce, which would hand the
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

    // Takes part in the steps of the solver whose list this is, on `body`. May be called again at any time.
    void join(List& list, const btAlignedObjectArray<btSoftBody::Node*>& nodes, btSoftBody& body);
    bool hasJoined() const { return list_ != nullptr; }
    // Ends that. @pre the solver exists
    void leave();
    // From now on pulls at nothing; if it is still in a list, it leaves at the solver's next step.
    void release();

    // Reads stiffness off the mechanics, as of this substep.
    void update();

    // Upper bound of the square of the sheet's angular frequencies, 1/s2, in any pose and without pins, for
    // stiffness that is `stretchRatio` and `bendingRatio` times that of the dry cloth (Gershgorin).
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
        btVector3 direction = btVector3(0, 0, 0);  // as last gathered
        btScalar tension = 0;                      // N
        btScalar acrossStiffness = 0;              // N/m, never negative
    };
    struct Plate {
        int count = 0;  // of its nodes
        std::array<int, 6> nodes;
        std::array<std::array<btScalar, 6>, 3> weights;
        std::array<std::size_t, 3> corners;
        double dryStiffness;     // B area, N m3
        btScalar stiffness = 0;  // N m3

        // Sum over its nodes, relative to the first: the weights of a curvature add up to nothing.
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
    std::vector<btVector3> positions_;  // as last gathered
    List* list_ = nullptr;              // that this is in; none once its body has left the world
    int first_ = 0;                     // index of the body's first node among all of the world's
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
