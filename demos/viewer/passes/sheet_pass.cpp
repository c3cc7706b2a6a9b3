#include "viewer/passes/sheet_pass.h"

#include "viewer/passes/sheet_surface.h"
#include "viewer/shaders/shaders.h"

namespace drench::viewer {

SheetPass::SheetPass()
    : roundingProgram_(ShaderProgram::capturing(
          "sheet rounding", {shaders::sheetRounding},
          {"positionAndRoundness", "normalAndHollow", "albedoAndValue", "clothAndWater", "moreWater"})),
      program_("sheet", {shaders::frame, shaders::sheetVertex},
               {shaders::frame, shaders::sheetBlock, shaders::sky, shaders::occlusion, shaders::material,
                shaders::noise, shaders::relief, shaders::threads, shaders::cloth, shaders::hem, shaders::dye,
                shaders::seeThrough, shaders::sheetLight, shaders::sheetFragment}),
      shadowProgram_("sheet shadow", {shaders::frame, shaders::sheetVertex},
                     {shaders::dye, shaders::sheetShadowFragment}),
      layerProgram_("sheet layer", {shaders::frame, shaders::sheetVertex}, {shaders::sheetLayerFragment}) {}

void SheetPass::upload(const Picture& picture, std::vector<Eigen::Vector3f>& casters) {
    count_ = 0;
    for (const SheetMesh& sheet : picture.sheets) {
        const auto nodes = sheetSurface(sheet);
        if (!nodes) continue;
        if (count_ == sheets_.size()) sheets_.emplace_back();
        sheets_[count_++].upload(*nodes, sheet.triangles, sheetUniforms(sheet, picture.legend));
        casters.insert(casters.end(), sheet.positions.begin(), sheet.positions.end());
    }
}

void SheetPass::round() const {
    for (std::size_t i = 0; i < count_; ++i) sheets_[i].round(roundingProgram_);
}

void SheetPass::drawShadows() const {
    shadowProgram_.use();
    drawAll();
}

void SheetPass::drawLayers() const {
    layerProgram_.use();
    drawAll();
}

void SheetPass::draw() const {
    program_.use();
    drawAll();
}

void SheetPass::drawAll() const {
    for (std::size_t i = 0; i < count_; ++i) sheets_[i].draw();
}

}  // namespace drench::viewer
