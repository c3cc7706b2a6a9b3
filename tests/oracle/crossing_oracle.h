// Counts the faces that cross by CGAL, which is not ours.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <array>
#include <vector>

namespace drench::test {

// Triangles that may cross.
struct CrossingSurface {
    std::vector<std::array<double, 3>> points;  // m
    std::vector<std::array<int, 3>> faces;      // neighbours in any sense

    void add(const btSoftBody& body) {
        const auto first = static_cast<int>(points.size());
        for (int n = 0; n < body.m_nodes.size(); ++n) {
            const btVector3& at = body.m_nodes[n].m_x;
            points.push_back({double(at.x()), double(at.y()), double(at.z())});
        }
        for (int f = 0; f < body.m_faces.size(); ++f) {
            std::array<int, 3>& corners = faces.emplace_back();
            for (int i = 0; i < 3; ++i)
                corners[static_cast<std::size_t>(i)] =
                    first + static_cast<int>(body.m_faces[f].m_n[i] - &body.m_nodes[0]);
        }
    }
};

// Number of pairs of faces that have a point in common, but no corner: CGAL::Polygon_mesh_processing::self_intersections.
// @throws std::runtime_error for faces of which more than two have an edge
int crossingsByCgal(const CrossingSurface& surface);

// Of bodies with themselves and each other.
inline int crossingsByCgal(const std::vector<const btSoftBody*>& bodies) {
    CrossingSurface surface;
    for (const btSoftBody* const body : bodies) surface.add(*body);
    return crossingsByCgal(surface);
}

}  // namespace drench::test
