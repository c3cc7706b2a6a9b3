#include "pose.h"

#include "vectors.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

Pose::Pose(const ClothMesh& mesh)
    : positions(mesh.size()), velocities(mesh.size()), trianglesAround(mesh.size()) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const int node : mesh.triangles[t])
            trianglesAround[static_cast<std::size_t>(node)].push_back(static_cast<int>(t));
}

void Pose::gatherHeights(const btSoftBody& body, std::vector<float>& heights) {
    const Eigen::Vector3d down = toEigen(body.m_worldInfo->m_gravity);
    gravity = down.norm();
    up = gravity > 0 ? Eigen::Vector3d(-down / gravity) : Eigen::Vector3d::Zero();
    heights.resize(positions.size());
    // From the first node, so that a sheet far from the origin keeps its digits.
    const btVector3 origin = body.m_nodes[0].m_x, direction = toBullet(up);
    for (int n = 0; n < body.m_nodes.size(); ++n)
        heights[static_cast<std::size_t>(n)] = float((body.m_nodes[n].m_x - origin).dot(direction));
}

void Pose::gatherMotion(const btSoftBody& body) {
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        positions[static_cast<std::size_t>(n)] = toEigen(body.m_nodes[n].m_x);
        velocities[static_cast<std::size_t>(n)] = toEigen(body.m_nodes[n].m_v);
    }
}

Eigen::Vector3d meanVelocity(const btSoftBody& body, const ClothMesh& mesh) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double area = 0;
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        const double weight = mesh.areas[static_cast<std::size_t>(n)];
        sum += weight * toEigen(body.m_nodes[n].m_v);
        area += weight;
    }
    return area > 0 ? Eigen::Vector3d(sum / area) : sum;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
