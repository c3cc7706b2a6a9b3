#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "bullet/sheet/link_order.h"
#include "bullet/sheet/node_masses.h"
#include "bullet/world/vectors.h"
#include "checks/checks.h"
#include "cloth/mesh_edges.h"
#include "drench/sheet.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

const Eigen::Vector3d& position(const TriangleMesh& mesh, int node) {
    return mesh.vertices[static_cast<std::size_t>(node)];
}

// Whether two triangles are the halves of a quad, and their common edge is its diagonal.
bool isDiagonal(const TriangleMesh& mesh, const NodePair& edge, const NodePair& apices) {
    constexpr double longer = 1.1, flat = 0.9;  // cosine of the angle between the two halves
    const Eigen::Vector3d along = position(mesh, edge[1]) - position(mesh, edge[0]);
    std::array<Eigen::Vector3d, 2> normals;
    for (std::size_t k = 0; k < 2; ++k) {
        const Eigen::Vector3d from = position(mesh, apices[k]) - position(mesh, edge[0]);
        const Eigen::Vector3d to = position(mesh, apices[k]) - position(mesh, edge[1]);
        if (along.norm() < longer * std::max(from.norm(), to.norm())) return false;
        normals[k] = along.cross(from).normalized();
    }
    return -normals[0].dot(normals[1]) > flat;
}

// The second diagonals of quads, except those between nodes that are already linked.
std::set<NodePair> secondDiagonals(const TriangleMesh& mesh, const MeshEdges& edges) {
    std::set<NodePair> diagonals;
    for (std::size_t edge = 0; edge < edges.size(); ++edge) {
        const auto triangles = edges.trianglesAt(edge);
        if (triangles.size() != 2) continue;
        const auto apexOf = [&](const EdgeTriangle& at) { return mesh.triangles[at.triangle][at.apex]; };
        const NodePair apices = pairOf(apexOf(triangles[0]), apexOf(triangles[1]));
        if (apices[0] != apices[1] && !edges.find(apices[0], apices[1]) &&
            isDiagonal(mesh, edges.ends()[edge], apices))
            diagonals.insert(apices);
    }
    return diagonals;
}

void appendCloth(btSoftBody& body, const TriangleMesh& mesh) {
    for (const auto& triangle : mesh.triangles) body.appendFace(triangle[0], triangle[1], triangle[2]);
    const MeshEdges edges(mesh.triangles, mesh.vertices.size());
    std::vector<NodePair> links = edges.ends();
    const std::set<NodePair> diagonals = secondDiagonals(mesh, edges);
    links.insert(links.end(), diagonals.begin(), diagonals.end());
    for (const int i : colouredOrder(links, body.m_nodes.size())) {
        const NodePair& link = links[static_cast<std::size_t>(i)];
        body.appendLink(link[0], link[1]);
    }
}

void setMeshMasses(btSoftBody& body, double arealDensity) {
    writeClothMasses(body, arealDensity, [&](int face, btScalar inBullet) {
        const auto area = double(inBullet);
        if (!(area > 0) || !std::isfinite(btScalar(1 / (arealDensity * area))))
            refuse("mesh: triangle ", face, " has an area of ", sixDigits(area),
                   " m2 as Bullet sees it; set its nodes apart, move the mesh closer to "
                   "the origin, or scale it to metres");
    });
}

btScalar meanLinkLength(const btSoftBody& body) {
    btScalar total = 0;
    for (int i = 0; i < body.m_links.size(); ++i)
        total += (body.m_links[i].m_n[1]->m_x - body.m_links[i].m_n[0]->m_x).length();
    return total / btScalar(body.m_links.size());
}

// Fine enough for accurate contacts.
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
    std::vector<btVector3> positions;
    positions.reserve(mesh.vertices.size());
    for (const Eigen::Vector3d& vertex : mesh.vertices) positions.push_back(toBullet(vertex));
    auto body = std::make_unique<btSoftBody>(&worldInfo, static_cast<int>(positions.size()), positions.data(),
                                             nullptr);
    appendCloth(*body, mesh);
    setMeshMasses(*body, fabric.arealDensity);
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
