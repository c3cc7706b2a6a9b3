#include "bullet/sheet/sheet_mechanics.h"

#include <algorithm>
#include <utility>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// Pa; it leaves pores less than half a per cent less room.
constexpr double weightOfFewLayers = 10;

std::vector<SurfaceTree::Corners> materialCorners(const ClothMesh& mesh) {
    std::vector<SurfaceTree::Corners> all;
    for (const auto& triangle : mesh.coordinates) {
        SurfaceTree::Corners& corners = all.emplace_back();
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = {float(triangle[i].x()), float(triangle[i].y()), 0.0f};
    }
    return all;
}

}  // namespace

SheetMechanics::SheetMechanics(const Fabric& fabric, RestShape restShape, ClothMesh clothMesh)
    : shape(std::move(restShape)),
      mesh(std::move(clothMesh)),
      stretch(0.5 * (fabric.stretchWarp + fabric.stretchWeft)),
      bending(fabric.bending),
      bendingFriction(fabric.bendingFriction),
      dryStiffness(linkStiffness(fabric, mesh, shape.links)),
      sheetFriction(fabric, mesh),
      lightPressure(std::min(weightOfFewLayers, double(fabric.entryPressure))),
      masses(shape.nodeAreas.size()),
      saturations(shape.nodeAreas.size()),
      stretchRatios(shape.nodeAreas.size()),
      bendingRatios(shape.nodeAreas.size()),
      bendingFrictionRatios(shape.nodeAreas.size()) {}

void SheetMechanics::recut(const Fabric& fabric, RestShape restShape, ClothMesh clothMesh) {
    SheetMechanics cut(fabric, std::move(restShape), std::move(clothMesh));
    cut.sheetFriction.takeOver(sheetFriction);
    cut.smallSteps = smallSteps;
    cut.heldSubsteps = heldSubsteps;
    cut.times = times;
    cut.touchableWater = touchableWater;
    *this = std::move(cut);
}

void SheetMechanics::evaluate(const WetLaws& laws, const Moisture& moisture) {
    sheetFriction.evaluate(laws, moisture);
    for (std::size_t n = 0; n < masses.size(); ++n) {
        masses[n] = laws.mass(shape.nodeAreas[n], moisture.poreMass()[n] + moisture.filmMass()[n]);
        saturations[n] = moisture.saturation(n);
        const double moistureContent = moisture.moistureContent(n);
        stretchRatios[n] = laws.stretchRatio(moistureContent);
        bendingRatios[n] = laws.bendingRatio(moistureContent);
        bendingFrictionRatios[n] = laws.bendingFrictionRatio(moistureContent);
    }
}

SurfaceTree& SheetMechanics::treeFor(btScalar margin) {
    if (!tree_ || marginOfTree_ != margin)
        tree_ = std::make_unique<SurfaceTree>(mesh.triangles, mesh.size(), materialCorners(mesh),
                                              float(2 * margin));
    marginOfTree_ = margin;
    return *tree_;
}

double SheetMechanics::stiffness(std::size_t link) const {
    const auto a = static_cast<std::size_t>(shape.links[link].nodes[0]);
    const auto b = static_cast<std::size_t>(shape.links[link].nodes[1]);
    const auto& ratios = dryStiffness[link].kind == LinkKind::bending ? bendingRatios : stretchRatios;
    return dryStiffness[link].dry * 0.5 * (ratios[a] + ratios[b]);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
