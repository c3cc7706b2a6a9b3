#include "bullet/sheet/rest_shape.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "bullet/sheet/face_tree.h"
#include "bullet/world/vectors.h"
#include "cloth/mesh_edges.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

btScalar areaOf(const btSoftBody::Face& face) {
    const btVector3& origin = face.m_n[0]->m_x;
    return (face.m_n[1]->m_x - origin).cross(face.m_n[2]->m_x - origin).length() / 2;
}

void prime(btSoftBody& body) {
    if (!body.m_bUpdateRtCst) return;
    body.m_bUpdateRtCst = false;
    body.updateConstants();
}

void writeRestLengths(btSoftBody& body, const RestShape& shape) {
    for (int i = 0; i < body.m_links.size(); ++i) {
        btSoftBody::Link& link = body.m_links[i];
        link.m_rl = shape.restLengths[static_cast<std::size_t>(i)] * body.m_restLengthScale;
        link.m_c1 = link.m_rl * link.m_rl;
    }
}

void keepFaceTree(btSoftBody& body) {
    using Collision = btSoftBody::fCollision;
    const bool wantsFaceTree = (body.m_cfg.collisions & (Collision::VF_SS | Collision::SDF_RD)) != 0;
    if (wantsFaceTree && body.m_fdbvt.empty()) makeFaceTree(body);
}

void keepPrimed(btSoftBody& body, const RestShape& shape, bool meetsSoftBodies) {
    if (meetsSoftBodies) keepFaceTree(body);
    if (!body.m_bUpdateRtCst) return;
    body.m_bUpdateRtCst = false;
    writeRestLengths(body, shape);
}

RestShape restShapeOf(const btSoftBody& body) {
    const bool waiting = body.m_bUpdateRtCst;
    RestShape shape;
    shape.nodeAreas.assign(static_cast<std::size_t>(body.m_nodes.size()), 0.0);
    for (int f = 0; f < body.m_faces.size(); ++f) {
        const btSoftBody::Face& face = body.m_faces[f];
        const double area =
            waiting ? double(areaOf(face)) : 0.5 * double(face.m_ra);  // m_ra is twice the area
        shape.triangleAreas.push_back(area);
        std::array<int, 3> triangle;
        for (std::size_t corner = 0; corner < 3; ++corner) triangle[corner] = indexOf(body, face.m_n[corner]);
        addThirds(triangle, area, shape.nodeAreas);
        shape.triangles.push_back(triangle);
    }
    for (int i = 0; i < body.m_links.size(); ++i) {
        const btSoftBody::Link& link = body.m_links[i];
        const btScalar length =
            waiting ? (link.m_n[1]->m_x - link.m_n[0]->m_x).length() : link.m_rl / body.m_restLengthScale;
        shape.restLengths.push_back(length);
        shape.links.push_back(
            {{indexOf(body, link.m_n[0]), indexOf(body, link.m_n[1])}, link.m_bbending != 0, double(length)});
    }
    return shape;
}

ClothMesh clothMesh(const RestShape& shape, const std::vector<Eigen::Vector2d>& nodeCoordinates) {
    ClothMesh mesh = flatMesh(nodeCoordinates, shape.triangles);
    mesh.areas = shape.nodeAreas;
    return mesh;
}

std::vector<Eigen::Vector2d> flattened(const btSoftBody& body) {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (int n = 0; n < body.m_nodes.size(); ++n) centre += toEigen(body.m_nodes[n].m_x);
    centre /= double(body.m_nodes.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        const Eigen::Vector3d offset = toEigen(body.m_nodes[n].m_x) - centre;
        spread += offset * offset.transpose();
    }
    // Eigenvalues come in ascending order: the sheet is thinnest along the first direction.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
    const Eigen::Vector3d normal = axes.eigenvectors().col(0);
    const btSoftBody::Link& first = body.m_links[0];
    Eigen::Vector3d warp = toEigen(first.m_n[1]->m_x - first.m_n[0]->m_x);
    warp -= normal * normal.dot(warp);
    if (warp.norm() < 1e-12) warp = axes.eigenvectors().col(2);
    warp.normalize();
    const Eigen::Vector3d weft = normal.cross(warp);

    std::vector<Eigen::Vector2d> coordinates;
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        const Eigen::Vector3d offset = toEigen(body.m_nodes[n].m_x) - centre;
        coordinates.emplace_back(offset.dot(warp), offset.dot(weft));
    }
    return coordinates;
}

std::vector<Eigen::Vector2d> nodeCoordinates(const ClothMesh& mesh) {
    std::vector<Eigen::Vector2d> coordinates(mesh.size(), Eigen::Vector2d::Zero());
    for (std::size_t t = mesh.triangles.size(); t-- > 0;)  // so that the first face determines the value
        for (std::size_t corner = 0; corner < 3; ++corner)
            coordinates[static_cast<std::size_t>(mesh.triangles[t][corner])] = mesh.coordinates[t][corner];
    return coordinates;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
