// A sheet as whatever moves it needs to know it: its cloth at rest, and what water has made of it.
#pragma once

#include <memory>
#include <vector>

#include "bullet/contact/friction.h"
#include "bullet/sheet/rest_shape.h"
#include "cloth/link_stiffness.h"
#include "drench/cloth_mesh.h"
#include "drench/config.h"
#include "drench/fabric.h"
#include "drench/health.h"
#include "drench/moisture.h"
#include "drench/wet_laws.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

struct MovingSheet;

// Made by the layer, evaluated at the start of each substep, read by the solvers.
struct SheetMechanics {
    SheetMechanics(const Fabric& fabric, RestShape restShape, ClothMesh clothMesh);

    // Reads masses and the ratios of the wet laws off the water.
    void evaluate(const WetLaws& laws, const Moisture& moisture);
    // Stiffness of a link as of this substep, N/m.
    double stiffness(std::size_t link) const;
    // Becomes that of the same cloth, cut. @pre `evaluate` before anything else
    void recut(const Fabric& fabric, RestShape restShape, ClothMesh clothMesh);

    RestShape shape;
    ClothMesh mesh;
    double stretch;          // stretch stiffness of the dry cloth, mean of warp and weft, N/m
    double bending;          // bending rigidity of the dry cloth, N m
    double bendingFriction;  // of the dry cloth, N
    std::vector<LinkStiffness> dryStiffness;
    Friction sheetFriction;

    // Of each node, as of this substep.
    std::vector<double> masses;                 // kg
    std::vector<double> saturations;            // of the pores, 0 to 1
    std::vector<double> stretchRatios;          // wet over dry
    std::vector<double> bendingRatios;          // wet over dry
    std::vector<double> bendingFrictionRatios;  // wet over dry

    // Of a SmallStepSolver, once one has met the sheet.
    std::shared_ptr<MovingSheet> moving;
    bool movedBySmallSteps = false;  // in the last substep
    int smallSteps = 0;              // of the last substep
    int heldSubsteps = 0;            // that came to nothing finite
    int heldNode = -1;               // with which the last of them did
    bool fits = true;                // whether the body still is this cloth; if not, Drench lets it be

    StepTimes times;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
