#include "oracle/crossing_oracle.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace drench::test {

namespace {

namespace meshes = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Mesh::Face_index;

Mesh meshOf(const CrossingSurface& surface) {
    std::vector<Kernel::Point_3> points;
    for (const auto& at : surface.points) points.emplace_back(at[0], at[1], at[2]);
    std::vector<std::vector<std::size_t>> faces;
    for (const auto& of : surface.faces) faces.emplace_back(of.begin(), of.end());
    meshes::orient_polygon_soup(points, faces);
    if (points.size() != surface.points.size() || !meshes::is_polygon_soup_a_polygon_mesh(faces))
        throw std::runtime_error("CGAL takes only faces of which at most two have an edge");
    Mesh mesh;
    meshes::polygon_soup_to_polygon_mesh(points, faces, mesh);
    return mesh;
}

bool shareCorner(const Mesh& mesh, Face one, Face other) {
    const auto corners = mesh.vertices_around_face(mesh.halfedge(one)),
               others = mesh.vertices_around_face(mesh.halfedge(other));
    return std::any_of(corners.begin(), corners.end(), [&](auto corner) {
        return std::find(others.begin(), others.end(), corner) != others.end();
    });
}

}  // namespace

int crossingsByCgal(const CrossingSurface& surface) {
    const Mesh mesh = meshOf(surface);
    std::vector<std::pair<Face, Face>> found;
    meshes::self_intersections(mesh, std::back_inserter(found));
    return static_cast<int>(std::count_if(found.begin(), found.end(), [&](const auto& pair) {
        return !shareCorner(mesh, pair.first, pair.second);
    }));
}

}  // namespace drench::test
