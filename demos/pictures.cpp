#include "pictures.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

namespace drench::demo {

namespace {

Eigen::Quaternionf orientation(const btRigidBody& body) {
    const btQuaternion turn = body.getWorldTransform().getRotation();
    return {float(turn.w()), float(turn.x()), float(turn.y()), float(turn.z())};
}

}  // namespace

Eigen::Vector3f toEigen(const btVector3& v) {
    return {float(v.x()), float(v.y()), float(v.z())};
}

viewer::SheetMesh sheetMesh(const btSoftBody& body, const Eigen::Vector3f& albedo) {
    viewer::SheetMesh mesh;
    for (int n = 0; n < body.m_nodes.size(); ++n) mesh.positions.push_back(toEigen(body.m_nodes[n].m_x));
    mesh.albedo.assign(mesh.positions.size(), albedo);
    mesh.gloss.assign(mesh.positions.size(), 0);
    for (int f = 0; f < body.m_faces.size(); ++f) {
        std::array<std::uint32_t, 3> triangle;
        for (std::size_t corner = 0; corner < 3; ++corner)
            triangle[corner] = static_cast<std::uint32_t>(body.m_faces[f].m_n[corner] - &body.m_nodes[0]);
        mesh.triangles.push_back(triangle);
    }
    return mesh;
}

viewer::SheetMesh sheetMesh(const btSoftBody& body, const WetCloth& cloth) {
    viewer::SheetMesh mesh = sheetMesh(body, Eigen::Vector3f::Zero());
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        const auto place = static_cast<std::size_t>(n);
        const Colour albedo = cloth.albedo(n);
        mesh.albedo[place] = {float(albedo[0]), float(albedo[1]), float(albedo[2])};
        mesh.gloss[place] = float(cloth.gloss(n));
        mesh.clothCoordinates.push_back(cloth.materialCoordinates()[place].cast<float>());
    }
    return mesh;
}

viewer::Box box(const btRigidBody& body) {
    viewer::Box result;
    result.centre = toEigen(body.getWorldTransform().getOrigin());
    result.halfExtents =
        toEigen(static_cast<const btBoxShape*>(body.getCollisionShape())->getHalfExtentsWithMargin());
    result.orientation = orientation(body);
    return result;
}

viewer::Ball ball(const btRigidBody& body) {
    viewer::Ball result;
    result.centre = toEigen(body.getWorldTransform().getOrigin());
    result.radius = float(static_cast<const btSphereShape*>(body.getCollisionShape())->getRadius());
    result.orientation = orientation(body);
    return result;
}

}  // namespace drench::demo
