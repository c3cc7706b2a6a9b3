#include "viewer/passes/sheet_rounding.h"

namespace drench::viewer {

namespace {

using Corners = std::array<const SheetVertex*, 3>;
using Weights = std::array<float, 3>;

// Sums run over the corners in the same order, so that two triangles get identical points on their common
// edge, and there are no cracks.
template <typename Value>
Value mixed(const Corners& corners, const Weights& weights, Value SheetVertex::*field) {
    return weights[0] * corners[0]->*field + weights[1] * corners[1]->*field +
           weights[2] * corners[2]->*field;
}

// The sphere with these normals lies halfway between the flat triangle and the tangent planes at its corners.
Eigen::Vector3f bent(const Corners& corners, const Weights& weights) {
    const Eigen::Vector3f flat = mixed(corners, weights, &SheetVertex::position);
    std::array<Eigen::Vector3f, 3> lifts;
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3f& normal = corners[i]->normal;
        lifts[i] = weights[i] * corners[i]->roundness * normal.dot(corners[i]->position - flat) * normal;
    }
    return flat + 0.5f * (lifts[0] + lifts[1] + lifts[2]);
}

SheetVertex vertexAt(const Corners& corners, const Weights& weights) {
    SheetVertex vertex;
    vertex.position = bent(corners, weights);
    vertex.normal = mixed(corners, weights, &SheetVertex::normal);
    vertex.albedo = mixed(corners, weights, &SheetVertex::albedo);
    vertex.gloss = mixed(corners, weights, &SheetVertex::gloss);
    vertex.dampness = mixed(corners, weights, &SheetVertex::dampness);
    vertex.transmittance = mixed(corners, weights, &SheetVertex::transmittance);
    vertex.roundness = mixed(corners, weights, &SheetVertex::roundness);
    vertex.value = mixed(corners, weights, &SheetVertex::value);
    vertex.hollow = mixed(corners, weights, &SheetVertex::hollow);
    vertex.clothCoordinates = mixed(corners, weights, &SheetVertex::clothCoordinates);
    return vertex;
}

std::uint32_t piecesAlongAnEdge(std::size_t triangles) {
    if (triangles <= 20000) return 3;
    return triangles <= 60000 ? 2 : 1;
}

// The points of one triangle row by row: row i holds i + 1 of them.
void addVertices(SheetTriangles& result, const Corners& corners, std::uint32_t pieces) {
    const float fraction = 1.0f / static_cast<float>(pieces);
    for (std::uint32_t row = 0; row <= pieces; ++row) {
        for (std::uint32_t column = 0; column <= row; ++column) {
            const Weights weights{fraction * static_cast<float>(pieces - row),
                                  fraction * static_cast<float>(row - column),
                                  fraction * static_cast<float>(column)};
            result.vertices.push_back(vertexAt(corners, weights));
        }
    }
}

void addTriangles(SheetTriangles& result, std::uint32_t first, std::uint32_t pieces) {
    for (std::uint32_t row = 0; row < pieces; ++row) {
        const std::uint32_t upper = first + row * (row + 1) / 2;
        const std::uint32_t lower = upper + row + 1;
        for (std::uint32_t column = 0; column <= row; ++column) {
            result.triangles.push_back({upper + column, lower + column, lower + column + 1});
            if (column < row)
                result.triangles.push_back({upper + column, lower + column + 1, upper + column + 1});
        }
    }
}

}  // namespace

SheetTriangles rounded(const std::vector<SheetVertex>& nodes,
                       const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    const std::uint32_t pieces = piecesAlongAnEdge(triangles.size());
    SheetTriangles result;
    if (pieces == 1) {
        result.vertices = nodes;
        result.triangles = triangles;
        return result;
    }
    result.vertices.reserve(triangles.size() * (pieces + 1) * (pieces + 2) / 2);
    result.triangles.reserve(triangles.size() * pieces * pieces);
    for (const auto& [a, b, c] : triangles) {
        const auto first = static_cast<std::uint32_t>(result.vertices.size());
        addVertices(result, {&nodes[a], &nodes[b], &nodes[c]}, pieces);
        addTriangles(result, first, pieces);
    }
    return result;
}

}  // namespace drench::viewer
