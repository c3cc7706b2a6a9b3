#include "viewer/passes/solid_meshes.h"

#include <cmath>

namespace drench::viewer {

namespace {

void addCircle(SolidMesh& mesh, std::uint32_t segments, float latitude, float half) {
    constexpr float fullTurn = 6.2831853f;
    for (std::uint32_t i = 0; i < segments; ++i) {
        const float angle = fullTurn * static_cast<float>(i) / static_cast<float>(segments);
        mesh.vertices.emplace_back(std::cos(latitude) * std::cos(angle), std::sin(latitude),
                                   std::cos(latitude) * std::sin(angle), half);
    }
}

}  // namespace

SolidMesh capsuleMesh(std::uint32_t segments, std::uint32_t rings) {
    constexpr float quarterTurn = 1.5707963f;
    SolidMesh mesh;
    for (std::uint32_t i = 0; i <= rings; ++i) {
        addCircle(mesh, segments, quarterTurn * (static_cast<float>(i) / static_cast<float>(rings) - 1.0f),
                  0.0f);
    }
    for (std::uint32_t i = 0; i <= rings; ++i)
        addCircle(mesh, segments, quarterTurn * static_cast<float>(i) / static_cast<float>(rings), 1.0f);
    // One band more than the rings of both halves: the tube between the two equators.
    for (std::uint32_t band = 0; band < 2 * rings + 1; ++band) {
        for (std::uint32_t i = 0; i < segments; ++i) {
            const std::uint32_t next = (i + 1) % segments;
            const std::uint32_t below = band * segments;
            const std::uint32_t above = below + segments;
            mesh.triangles.push_back({below + i, above + i, above + next});
            mesh.triangles.push_back({below + i, above + next, below + next});
        }
    }
    return mesh;
}

SolidMesh boxMesh() {
    SolidMesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            for (const auto& [across, along] : {std::array{-1.0f, -1.0f}, std::array{1.0f, -1.0f},
                                                std::array{1.0f, 1.0f}, std::array{-1.0f, 1.0f}}) {
                Eigen::Vector4f corner;
                corner[axis] = side;
                corner[(axis + 1) % 3] = across;
                corner[(axis + 2) % 3] = along;
                corner[3] = static_cast<float>(axis);
                mesh.vertices.push_back(corner);
            }
            mesh.triangles.push_back({first, first + 1, first + 2});
            mesh.triangles.push_back({first, first + 2, first + 3});
        }
    }
    return mesh;
}

}  // namespace drench::viewer
