#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "bullet/sheet/link_order.h"
#include "bullet/world/vectors.h"
#include "checks/checks.h"
#include "drench/sheet.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

using Pair = std::array<int, 2>;

/// The triangles at each side.
std::map<Pair, std::vector<std::size_t>> trianglesAtSides(const TriangleMesh& mesh) {
    std::map<Pair, std::vector<std::size_t>> at;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
            at[{std::min(a, b), std::max(a, b)}].push_back(t);
        }
    return at;
}

const Eigen::Vector3d& place(const TriangleMesh& mesh, int node) {
    return mesh.vertices[static_cast<std::size_t>(node)];
}

int apexOver(const std::array<int, 3>& triangle, const Pair& side) {
    for (const int node : triangle)
        if (node != side[0] && node != side[1]) return node;
    return -1;
}

/// Whether two triangles are the halves of a cell that their side cuts from corner to corner.
bool isDiagonal(const TriangleMesh& mesh, const Pair& side, const Pair& apices) {
    constexpr double longer = 1.1, flat = 0.9;  // cosine of the angle between the two halves
    const Eigen::Vector3d along = place(mesh, side[1]) - place(mesh, side[0]);
    std::array<Eigen::Vector3d, 2> normals;
    for (std::size_t k = 0; k < 2; ++k) {
        const Eigen::Vector3d from = place(mesh, apices[k]) - place(mesh, side[0]);
        const Eigen::Vector3d to = place(mesh, apices[k]) - place(mesh, side[1]);
        if (along.norm() < longer * std::max(from.norm(), to.norm())) return false;
        normals[k] = along.cross(from).normalized();
    }
    return -normals[0].dot(normals[1]) > flat;
}

/// The second diagonals of cells, without those that join nodes which a link joins already.
std::vector<Pair> secondDiagonals(const TriangleMesh& mesh) {
    const auto at = trianglesAtSides(mesh);
    std::set<Pair> diagonals;
    for (const auto& [side, triangles] : at) {
        if (triangles.size() != 2) continue;
        const int a = apexOver(mesh.triangles[triangles[0]], side);
        const int b = apexOver(mesh.triangles[triangles[1]], side);
        const Pair apices{std::min(a, b), std::max(a, b)};
        if (a != b && at.count(apices) == 0 && isDiagonal(mesh, side, apices)) diagonals.insert(apices);
    }
    return {diagonals.begin(), diagonals.end()};
}

void appendCloth(btSoftBody& body, const TriangleMesh& mesh) {
    for (const auto& triangle : mesh.triangles) body.appendFace(triangle[0], triangle[1], triangle[2]);
    std::vector<Pair> links = sidesOf(mesh);
    const std::vector<Pair> diagonals = secondDiagonals(mesh);
    links.insert(links.end(), diagonals.begin(), diagonals.end());
    for (const int i : colouredOrder(links, body.m_nodes.size())) {
        const Pair& link = links[static_cast<std::size_t>(i)];
        body.appendLink(link[0], link[1]);
    }
}

/// Masses of cloth alone, a third of each face to each of its nodes.
void setMasses(btSoftBody& body, double arealDensity) {
    std::vector<double> masses(static_cast<std::size_t>(body.m_nodes.size()), 0.0);
    for (int f = 0; f < body.m_faces.size(); ++f) {
        const btSoftBody::Face& face = body.m_faces[f];
        const btVector3& origin = face.m_n[0]->m_x;
        const double area = double((face.m_n[1]->m_x - origin).cross(face.m_n[2]->m_x - origin).length()) / 2;
        if (!(area > 0) || !std::isfinite(btScalar(1 / (arealDensity * area))))
            refuse("mesh: triangle ", f, " has an area of ", sixDigits(area),
                   " m2 as Bullet sees it; set its nodes apart, move the mesh closer to "
                   "the origin, or scale it to metres");
        for (const btSoftBody::Node* node : face.m_n)
            masses[static_cast<std::size_t>(node - &body.m_nodes[0])] += arealDensity * area / 3;
    }
    for (int n = 0; n < body.m_nodes.size(); ++n)
        body.m_nodes[n].m_im = btScalar(1 / masses[static_cast<std::size_t>(n)]);
    body.updateLinkConstants();
}

btScalar meanLinkLength(const btSoftBody& body) {
    btScalar total = 0;
    for (int i = 0; i < body.m_links.size(); ++i)
        total += (body.m_links[i].m_n[1]->m_x - body.m_links[i].m_n[0]->m_x).length();
    return total / btScalar(body.m_links.size());
}

/// Fine enough for the sheet to touch things where it is.
void setContactSizes(btSoftBody& body, btSoftBodyWorldInfo& worldInfo) {
    const btScalar length = meanLinkLength(body);
    body.getCollisionShape()->setMargin(std::min(length / 4, btScalar(0.02)));
    if (worldInfo.m_sparsesdf.m_defaultVoxelsz <= length) return;
    worldInfo.m_sparsesdf.setDefaultVoxelsz(length / 2);
    worldInfo.m_sparsesdf.Reset();
}

}  // namespace

std::unique_ptr<btSoftBody> makeSheet(btSoftBodyWorldInfo& worldInfo, const Fabric& fabric,
                                      const TriangleMesh& mesh) {
    validate(fabric);
    validate(mesh);
    std::vector<btVector3> places;
    places.reserve(mesh.vertices.size());
    for (const Eigen::Vector3d& vertex : mesh.vertices) places.push_back(toBullet(vertex));
    auto body =
        std::make_unique<btSoftBody>(&worldInfo, static_cast<int>(places.size()), places.data(), nullptr);
    appendCloth(*body, mesh);
    setMasses(*body, fabric.arealDensity);
    body->m_cfg.kDF = btScalar(fabric.plateFrictionDry);
    setContactSizes(*body, worldInfo);
    return body;
}

void pin(btSoftBody& body, const std::vector<int>& nodes) {
    for (const int node : nodes)
        if (node < 0 || node >= body.m_nodes.size())
            refuse<std::out_of_range>("pin: there is no node ", node, " among ", body.m_nodes.size(),
                                      "; give 0 to ", body.m_nodes.size() - 1);
    for (const int node : nodes) body.m_nodes[node].m_im = 0;
}

std::vector<int> pinWhere(btSoftBody& body, const std::function<bool(const btVector3&)>& isPinned) {
    std::vector<int> nodes;
    for (int n = 0; n < body.m_nodes.size(); ++n)
        if (isPinned(body.m_nodes[n].m_x)) nodes.push_back(n);
    pin(body, nodes);
    return nodes;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
