#include "pose.h"

#include "vectors.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

Pose::Pose(const ClothMesh& mesh)
    : places(mesh.size() + 1, MovingNode{0, 0, 0, 0}),
      speeds(mesh.size() + 1, MovingNode{0, 0, 0, 0}),
      heights(mesh.size()),
      positions(mesh.size()),
      velocities(mesh.size()),
      trianglesAround(mesh.size()) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const int node : mesh.triangles[t])
            trianglesAround[static_cast<std::size_t>(node)].push_back(static_cast<int>(t));
}

void Pose::gather(const btSoftBody& body, const ClothMesh& mesh) {
    const Eigen::Vector3d down = toEigen(body.m_worldInfo->m_gravity);
    gravity = down.norm();
    up = gravity > 0 ? Eigen::Vector3d(-down / gravity) : Eigen::Vector3d::Zero();
    const btVector3 origin = body.m_nodes[0].m_x, direction = toBullet(up);
    btVector3 momentum(0, 0, 0);
    btScalar area = 0, sum = 0;
    for (std::size_t n = 0; n < heights.size(); ++n) {
        const btSoftBody::Node& node = body.m_nodes[static_cast<int>(n)];
        const btVector3 place = node.m_x - origin, &velocity = node.m_v;
        places[n] = {float(place.x()), float(place.y()), float(place.z()), 0};
        speeds[n] = {float(velocity.x()), float(velocity.y()), float(velocity.z()), 0};
        heights[n] = float(place.dot(direction));
        momentum += velocity * btScalar(mesh.areas[n]);
        area += btScalar(mesh.areas[n]);
        const btVector3 all = node.m_x + velocity + node.m_f;
        sum += (all.x() + all.y() + all.z()) * 0;  // NaN for what is not finite
    }
    isFinite = sum == 0;
    meanVelocity = area > 0 ? toEigen(momentum / area) : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

void Pose::gatherMotion(const btSoftBody& body) {
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        positions[static_cast<std::size_t>(n)] = toEigen(body.m_nodes[n].m_x);
        velocities[static_cast<std::size_t>(n)] = toEigen(body.m_nodes[n].m_v);
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
