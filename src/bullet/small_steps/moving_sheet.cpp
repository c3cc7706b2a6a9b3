#include "bullet/small_steps/moving_sheet.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

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

SurfaceTree& MovingSheet::treeFor(btScalar margin, const SheetMechanics& mechanics) {
    if (!tree_ || margin_ != margin)
        tree_ = std::make_unique<SurfaceTree>(mechanics.mesh.triangles, mechanics.mesh.size(),
                                              materialCorners(mechanics.mesh), float(2 * margin));
    margin_ = margin;
    return *tree_;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
