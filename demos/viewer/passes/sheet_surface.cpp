#include "viewer/passes/sheet_surface.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "checks/text.h"
#include "viewer/passes/shader_values.h"

namespace drench::viewer {

namespace {

void requireSize(const char* list, std::size_t size, std::size_t nodes) {
    if (size != nodes) {
        throw std::runtime_error(textOf("viewer: a sheet has ", nodes, " positions but ", size,
                                        " entries in ", list, "; give one for each node"));
    }
}

void requireConsistent(const SheetMesh& sheet) {
    const std::size_t nodes = sheet.positions.size();
    requireSize("albedo", sheet.albedo.size(), nodes);
    requireSize("gloss", sheet.gloss.size(), nodes);
    const auto requireSizeIfAny = [&](const char* list, std::size_t size) {
        if (size > 0) requireSize(list, size, nodes);
    };
    requireSizeIfAny("clothCoordinates", sheet.clothCoordinates.size());
    requireSizeIfAny("dampness", sheet.dampness.size());
    requireSizeIfAny("transmittance", sheet.transmittance.size());
    requireSizeIfAny("values", sheet.values.size());
    if (!(sheet.threadSpacing > 0.0f)) {
        throw std::runtime_error(
            textOf("viewer: a sheet has a thread spacing of ", sheet.threadSpacing, " m; give one above 0"));
    }
    for (const auto& triangle : sheet.triangles) {
        for (const std::uint32_t node : triangle) {
            if (node >= nodes) {
                throw std::runtime_error(textOf("viewer: a triangle of a sheet names node ", node,
                                                ", but the sheet has ", nodes, " nodes"));
            }
        }
    }
}

bool drawable(const SheetMesh& sheet) {
    if (sheet.triangles.empty()) return false;
    for (std::size_t i = 0; i < sheet.positions.size(); ++i)
        if (!isDrawable(sheet.positions[i]) || !sheet.albedo[i].allFinite() || !std::isfinite(sheet.gloss[i]))
            return false;
    return true;
}

// Value of a node in a list that may be empty; 0 if missing or not finite.
float entry(const std::vector<float>& list, std::size_t node) {
    return list.empty() || !std::isfinite(list[node]) ? 0.0f : list[node];
}

std::vector<SheetVertex> bareVertices(const SheetMesh& sheet) {
    std::vector<SheetVertex> vertices(sheet.positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        SheetVertex& vertex = vertices[i];
        vertex.position = sheet.positions[i];
        vertex.normal.setZero();
        vertex.albedo = sheet.albedo[i].cwiseMax(0.0f).cwiseMin(1.0f);
        vertex.gloss = std::clamp(sheet.gloss[i], 0.0f, 1.0f);
        vertex.dampness = std::clamp(entry(sheet.dampness, i), 0.0f, 1.0f);
        vertex.transmittance = std::clamp(entry(sheet.transmittance, i), 0.0f, 1.0f);
        vertex.value = entry(sheet.values, i);
        vertex.hollow = 0.0f;
        // Constant coordinates disable the weave pattern.
        vertex.clothCoordinates.setZero();
        if (!sheet.clothCoordinates.empty() && sheet.clothCoordinates[i].allFinite())
            vertex.clothCoordinates = sheet.clothCoordinates[i];
    }
    return vertices;
}

// Computed from the agreement of the normals around a node, 0 to 1. At a fold as tight as the width of a
// triangle their sum has about 0.8 of its full length; with more rounding the two sides of the fold would
// intersect.
float roundnessOf(float agreement) {
    constexpr float sharp = 0.75f, smooth = 0.93f;
    return std::clamp((agreement - sharp) / (smooth - sharp), 0.0f, 1.0f);
}

void computeNormals(const SheetMesh& sheet, std::vector<SheetVertex>& vertices) {
    std::vector<float> areas(vertices.size(), 0.0f);
    for (const auto& triangle : sheet.triangles) {
        const auto& [a, b, c] = triangle;
        const Eigen::Vector3f origin = vertices[a].position;
        // The length of the cross product is twice the area, so the average is area-weighted.
        const Eigen::Vector3f normal = (vertices[b].position - origin).cross(vertices[c].position - origin);
        const float area = normal.norm();
        for (const std::uint32_t corner : triangle) {
            vertices[corner].normal += normal;
            areas[corner] += area;
        }
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        SheetVertex& vertex = vertices[i];
        const float length = vertex.normal.norm();
        vertex.roundness = areas[i] > 0.0f ? roundnessOf(length / areas[i]) : 0.0f;
        vertex.normal = length > 0.0f ? Eigen::Vector3f(vertex.normal / length) : Eigen::Vector3f::UnitY();
    }
}

void computeHollows(const SheetMesh& sheet, std::vector<SheetVertex>& vertices) {
    std::vector<float> rise(vertices.size(), 0.0f);
    std::vector<float> spread(vertices.size(), 0.0f);
    const auto addEdge = [&](std::uint32_t from, std::uint32_t to) {
        const Eigen::Vector3f edge = vertices[to].position - vertices[from].position;
        rise[from] += edge.dot(vertices[from].normal);
        spread[from] += edge.squaredNorm();
    };
    for (const auto& [a, b, c] : sheet.triangles) {
        addEdge(a, b);
        addEdge(a, c);
        addEdge(b, a);
        addEdge(b, c);
        addEdge(c, a);
        addEdge(c, b);
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        // A circle of curvature k rises by k * d^2 / 2 at the distance d.
        vertices[i].hollow = spread[i] > 0.0f ? 2.0f * rise[i] / spread[i] : 0.0f;
    }
}

}  // namespace

std::optional<std::vector<SheetVertex>> sheetSurface(const SheetMesh& sheet) {
    requireConsistent(sheet);
    if (!drawable(sheet)) return std::nullopt;
    std::vector<SheetVertex> vertices = bareVertices(sheet);
    computeNormals(sheet, vertices);
    computeHollows(sheet, vertices);
    return vertices;
}

}  // namespace drench::viewer
