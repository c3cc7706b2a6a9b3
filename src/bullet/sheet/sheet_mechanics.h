// Mechanical properties of a sheet for the solvers: its cloth at rest, and the effect of its water.
#pragma once

#include <LinearMath/btVector3.h>

#include <memory>
#include <vector>

#include "bullet/cloth_contact/surface_tree.h"
#include "bullet/contact/friction.h"
#include "bullet/contact/motors.h"
#include "bullet/contact/near_solids.h"
#include "bullet/sheet/layer_touches.h"
#include "bullet/sheet/rest_shape.h"
#include "cloth/link_stiffness.h"
#include "drench/cloth_mesh.h"
#include "drench/config.h"
#include "drench/fabric.h"
#include "drench/health.h"
#include "drench/moisture.h"
#include "drench/wet_laws.h"

namespace drench {

class Supply;

inline namespace DRENCH_BULLET_NAMESPACE {

struct MovingSheet;

// The water of a sheet, for other sheets that touch it.
class TouchableWater {
  public:
    virtual const Fabric& fabricOfWater() const = 0;
    virtual const Moisture& water() const = 0;
    virtual Supply& touchAccount() = 0;
    virtual double speedOfWater() const = 0;
    virtual double pressureOn(std::size_t node) const = 0;  // Pa

  protected:
    ~TouchableWater() = default;
};

// Created by the layer, evaluated at the start of each substep, read by the solvers.
struct SheetMechanics {
    SheetMechanics(const Fabric& fabric, RestShape restShape, ClothMesh clothMesh);

    // Computes masses and the wet-to-dry ratios from the water.
    void evaluate(const WetLaws& laws, const Moisture& moisture);
    // Present stiffness of a link, N/m.
    double stiffness(std::size_t link) const;
    // The faces of the sheet in a tree. Made at the first call, and again for another margin.
    SurfaceTree& treeFor(btScalar margin);
    // Adapts to the cloth after a cut. @pre `evaluate` must be called before any other use
    void recut(const Fabric& fabric, RestShape restShape, ClothMesh clothMesh);

    RestShape shape;
    ClothMesh mesh;
    double stretch;          // stretch stiffness of the dry cloth, mean of warp and weft, N/m
    double bending;          // bending rigidity of the dry cloth, N m
    double bendingFriction;  // bending friction of the dry cloth, N
    std::vector<LinkStiffness> dryStiffness;
    Friction sheetFriction;
    double lightPressure;  // that squeezes hardly anything out of the cloth, Pa

    // For each node, in this substep.
    std::vector<double> masses;                 // kg
    std::vector<double> saturations;            // of the pores, 0 to 1
    std::vector<double> stretchRatios;          // ratio of wet to dry
    std::vector<double> bendingRatios;          // ratio of wet to dry
    std::vector<double> bendingFrictionRatios;  // ratio of wet to dry

    btVector3 gravity = btVector3(0, 0, 0);  // of the body in this substep, m/s2; see gravityOf

    bool meetsItself = true;  // see SheetSettings
    bool meetsSheets = true;
    Motors motors;    // of the world, in this substep
    NearSolids near;  // as the SmallStepSolver last saw them

    TouchableWater* touchableWater = nullptr;  // of the layer
    LayerTouches touches;                      // at the end of the last substep

    // Set by a SmallStepSolver, once it has found the sheet.
    std::shared_ptr<MovingSheet> moving;
    bool movedBySmallSteps = false;  // in the last substep
    bool hasJumped = false;          // the application has put the sheet elsewhere since then
    int smallSteps = 0;              // of the last substep
    int heldSubsteps = 0;            // substeps that were held because the result was not finite
    int heldNode = -1;               // first invalid node in the last of them
    bool fits = true;                // whether the body has this topology

    StepTimes times;

  private:
    std::unique_ptr<SurfaceTree> tree_;
    btScalar marginOfTree_ = 0;  // m
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
