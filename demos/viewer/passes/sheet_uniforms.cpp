#include "viewer/passes/sheet_uniforms.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace drench::viewer {

namespace {

struct Bounds {
    Eigen::Vector2f low;
    Eigen::Vector2f high;
};

Bounds clothBounds(const std::vector<Eigen::Vector2f>& coordinates) {
    Bounds bounds{Eigen::Vector2f::Zero(), Eigen::Vector2f::Zero()};
    if (!coordinates.empty()) bounds = {coordinates.front(), coordinates.front()};
    for (const Eigen::Vector2f& at : coordinates) {
        bounds.low = bounds.low.cwiseMin(at);
        bounds.high = bounds.high.cwiseMax(at);
    }
    return bounds;
}

float clothArea(const SheetMesh& sheet) {
    float area = 0.0f;
    for (const auto& [a, b, c] : sheet.triangles) {
        Eigen::Matrix2f edges;
        edges << sheet.clothCoordinates[b] - sheet.clothCoordinates[a],
            sheet.clothCoordinates[c] - sheet.clothCoordinates[a];
        area += 0.5f * std::abs(edges.determinant());
    }
    return area;
}

float hemWidth(const SheetMesh& sheet, const Bounds& bounds) {
    const Eigen::Vector2f size = bounds.high - bounds.low;
    const float box = size.x() * size.y();
    const bool rectangle = box > 0.0f && std::abs(clothArea(sheet) - box) < 0.01f * box;
    // Narrow strips have no hem.
    constexpr float narrow = 0.15f;
    return rectangle && size.minCoeff() > narrow ? std::clamp(0.015f * size.minCoeff(), 0.003f, 0.015f)
                                                 : 0.0f;
}

}  // namespace

SheetUniforms sheetUniforms(const SheetMesh& sheet, const std::optional<Legend>& legend) {
    SheetUniforms uniforms{};
    if (!sheet.clothCoordinates.empty()) {
        const Bounds bounds = clothBounds(sheet.clothCoordinates);
        uniforms.clothBounds = {bounds.low.x(), bounds.low.y(), bounds.high.x(), bounds.high.y()};
        uniforms.threading = {sheet.threadSpacing, static_cast<float>(sheet.weave), hemWidth(sheet, bounds),
                              0.0f};
    }
    if (legend && !sheet.values.empty()) uniforms.legend = {legend->from, legend->to, 1.0f, 0.0f};
    for (std::size_t stop = 0; stop < colourStops; ++stop) {
        const Eigen::Vector3f colour = mappedColour(static_cast<float>(stop) / (colourStops - 1));
        uniforms.legendColours[stop] = {colour.x(), colour.y(), colour.z(), 1.0f};
    }
    return uniforms;
}

}  // namespace drench::viewer
