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
        vertex.albedo = sheet.albedo[i].cwiseMax(0.0f).cwiseMin(1.0f);
        vertex.gloss = std::clamp(sheet.gloss[i], 0.0f, 1.0f);
        vertex.dampness = std::clamp(entry(sheet.dampness, i), 0.0f, 1.0f);
        vertex.transmittance = std::clamp(entry(sheet.transmittance, i), 0.0f, 1.0f);
        vertex.value = entry(sheet.values, i);
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

// Sums over the triangles around a node.
struct Surroundings {
    // Twice as long as the triangles are large.
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
    float doubleArea = 0.0f;
    // Their edges away from the node.
    Eigen::Vector3f edges = Eigen::Vector3f::Zero();
    float squaredLengths = 0.0f;
};

std::vector<Surroundings> surroundings(const SheetMesh& sheet) {
    std::vector<Surroundings> result(sheet.positions.size());
    for (const auto& [a, b, c] : sheet.triangles) {
        const Eigen::Vector3f ab = sheet.positions[b] - sheet.positions[a];
        const Eigen::Vector3f bc = sheet.positions[c] - sheet.positions[b];
        const Eigen::Vector3f ca = sheet.positions[a] - sheet.positions[c];
        const Eigen::Vector3f normal = ca.cross(ab);
        const float doubleArea = normal.norm();
        const auto add = [&](std::uint32_t corner, const Eigen::Vector3f& to, const Eigen::Vector3f& from) {
            Surroundings& sums = result[corner];
            sums.normal += normal;
            sums.doubleArea += doubleArea;
            sums.edges += to - from;
            sums.squaredLengths += to.squaredNorm() + from.squaredNorm();
        };
        add(a, ab, ca);
        add(b, bc, ab);
        add(c, ca, bc);
    }
    return result;
}

void computeShape(const SheetMesh& sheet, std::vector<SheetVertex>& vertices) {
    const std::vector<Surroundings> around = surroundings(sheet);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        SheetVertex& vertex = vertices[i];
        const Surroundings& sums = around[i];
        const float length = sums.normal.norm();
        vertex.roundness = sums.doubleArea > 0.0f ? roundnessOf(length / sums.doubleArea) : 0.0f;
        vertex.normal = length > 0.0f ? Eigen::Vector3f(sums.normal / length) : Eigen::Vector3f::UnitY();
        // A circle of curvature k rises by k * d^2 / 2 at the distance d.
        const float rise = sums.edges.dot(vertex.normal);
        vertex.hollow = sums.squaredLengths > 0.0f ? 2.0f * rise / sums.squaredLengths : 0.0f;
    }
}

}  // namespace

std::optional<std::vector<SheetVertex>> sheetSurface(const SheetMesh& sheet) {
    requireConsistent(sheet);
    if (!drawable(sheet)) return std::nullopt;
    std::vector<SheetVertex> vertices = bareVertices(sheet);
    computeShape(sheet, vertices);
    return vertices;
}

}  // namespace drench::viewer
