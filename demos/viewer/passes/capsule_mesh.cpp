#include "viewer/passes/capsule_mesh.h"

#include <cmath>

namespace drench::viewer {

namespace {

void addCircle(CapsuleMesh& mesh, std::uint32_t segments, float latitude, float half) {
    constexpr float fullTurn = 6.2831853f;
    for (std::uint32_t i = 0; i < segments; ++i) {
        const float angle = fullTurn * static_cast<float>(i) / static_cast<float>(segments);
        mesh.vertices.emplace_back(std::cos(latitude) * std::cos(angle), std::sin(latitude),
                                   std::cos(latitude) * std::sin(angle), half);
    }
}

}  // namespace

CapsuleMesh capsuleMesh(std::uint32_t segments, std::uint32_t rings) {
    constexpr float quarterTurn = 1.5707963f;
    CapsuleMesh mesh;
    for (std::uint32_t i = 0; i <= rings; ++i) {
        addCircle(mesh, segments, quarterTurn * (static_cast<float>(i) / static_cast<float>(rings) - 1.0f),
                  0.0f);
    }
    for (std::uint32_t i = 0; i <= rings; ++i) {
        addCircle(mesh, segments, quarterTurn * static_cast<float>(i) / static_cast<float>(rings), 1.0f);
    }
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

}  // namespace drench::viewer
