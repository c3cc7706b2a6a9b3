#include "viewer/sheet_pass.h"

#include "viewer/shaders_lighting.h"
#include "viewer/shaders_noise.h"
#include "viewer/shaders_sheet.h"
#include "viewer/shaders_solids.h"
#include "viewer/sheet_rounding.h"

namespace drench::viewer {

SheetPass::SheetPass()
    : program_("sheet", {shaders::frame, shaders::sheetVertex},
               {shaders::frame, shaders::sky, shaders::occlusion, shaders::material, shaders::noise,
                shaders::weave, shaders::sheetFragment}),
      shadowProgram_("sheet shadow", {shaders::frame, shaders::sheetVertex}, {shaders::depthFragment}) {}

void SheetPass::upload(const std::vector<SheetMesh>& sheets, std::vector<Eigen::Vector3f>& casters) {
    count_ = 0;
    for (const SheetMesh& sheet : sheets) {
        const auto vertices = sheetSurface(sheet);
        if (!vertices) {
            continue;
        }
        if (count_ == sheets_.size()) {
            sheets_.emplace_back();
        }
        sheets_[count_++].upload(rounded(*vertices, sheet.triangles));
        casters.insert(casters.end(), sheet.positions.begin(), sheet.positions.end());
    }
}

void SheetPass::drawShadows() const {
    shadowProgram_.use();
    drawAll();
}

void SheetPass::draw() const {
    program_.use();
    drawAll();
}

void SheetPass::drawAll() const {
    for (std::size_t i = 0; i < count_; ++i) {
        sheets_[i].draw();
    }
}

}  // namespace drench::viewer
