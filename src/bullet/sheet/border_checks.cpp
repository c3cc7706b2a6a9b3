#include "bullet/sheet/border_checks.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "checks/checks.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

bool isFinite(const btVector3& v) {
    return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

bool containsPlane(const btCollisionShape& shape) {
    if (shape.getShapeType() == STATIC_PLANE_PROXYTYPE) return true;
    if (!shape.isCompound()) return false;
    const auto& compound = static_cast<const btCompoundShape&>(shape);
    for (int child = 0; child < compound.getNumChildShapes(); ++child)
        if (containsPlane(*compound.getChildShape(child))) return true;
    return false;
}

// Whether the collision filters let two objects collide; an object that is in no world yet may collide.
bool mayMeet(const btBroadphaseProxy* a, const btBroadphaseProxy* b) {
    if (!a || !b) return true;
    return (a->m_collisionFilterGroup & b->m_collisionFilterMask) != 0 &&
           (b->m_collisionFilterGroup & a->m_collisionFilterMask) != 0;
}

}  // namespace

double meanLinkLength(const RestShape& shape) {
    const auto isStretched = [&](std::size_t link) { return !shape.links[link].bending; };
    return meanLength(shape.links, isStretched).value_or(shape.links[0].length);
}

void checkBody(const btSoftBody& body) {
    if (body.getInternalType() != btCollisionObject::CO_SOFT_BODY)
        refuse(
            "WetCloth: the body does not look like a btSoftBody; compile the application, Bullet and Drench "
            "with the same precision (BT_USE_DOUBLE_PRECISION)");
    if (body.m_tetras.size() > 0)
        refuse("WetCloth: the body has ", body.m_tetras.size(),
               " tetrahedra; a cloth is a surface, give a body of faces and links");
    if (body.m_faces.size() == 0)
        refuse("WetCloth: the body has no faces; water needs area, so append the cloth's triangles");
    if (body.m_links.size() == 0)
        refuse("WetCloth: the body has no links; append one along each edge of its triangles");
    using Collision = btSoftBody::fCollision;
    if (body.m_clusters.size() > 0 ||
        (body.m_cfg.collisions & (Collision::CL_RS | Collision::CL_SS | Collision::CL_SELF)))
        refuse("WetCloth: the body collides by clusters (", body.m_clusters.size(),
               " of them), which keep the masses of the dry cloth; use m_cfg.collisions = SDF_RS (and VF_SS) "
               "and do not call generateClusters");
    for (int n = 0; n < body.m_nodes.size(); ++n)
        if (!isFinite(body.m_nodes[n].m_x) || !isFinite(body.m_nodes[n].m_v))
            refuse("WetCloth: node ", n, " is at ", body.m_nodes[n].m_x, " m, with a velocity of ",
                   body.m_nodes[n].m_v, " m/s; give finite numbers before attaching");
}

void checkPlanes(const btCollisionWorld& world, const btSoftBody& body) {
    for (int i = 0; i < world.getNumCollisionObjects(); ++i) {
        const btCollisionObject& object = *world.getCollisionObjectArray()[i];
        if (containsPlane(*object.getCollisionShape()) && object.hasContactResponse() &&
            mayMeet(object.getBroadphaseHandle(), body.getBroadphaseHandle()))
            refuse(
                "WetCloth: collision object ", i,
                " is a plane shape, above which Bullet lets soft bodies float by a tenth of a metre; use a "
                "btBoxShape for the ground, or filter the pair out");
    }
}

void checkContacts(const btSoftBody& body, const RestShape& shape) {
    const double link = meanLinkLength(shape);
    const double voxel = double(body.m_worldInfo->m_sparsesdf.voxelsz);
    if (voxel > link)
        refuse("WetCloth: the distance field of the body's world info has voxels of ", sixDigits(voxel),
               " m, coarser than the sheet's mean link of ", sixDigits(link),
               " m; call body.getWorldInfo()->m_sparsesdf.setDefaultVoxelsz(", sixDigits(link / 2),
               ") and then m_sparsesdf.Reset()");
    const double margin = double(body.getCollisionShape()->getMargin());
    if (!(margin >= 0 && margin <= link))
        refuse("WetCloth: the body's collision margin is ", sixDigits(margin),
               " m, which is below 0 or larger than its mean link of ", sixDigits(link),
               " m; call body.getCollisionShape()->setMargin(", sixDigits(link / 4), ")");
}

void checkDuplicates(const RestShape& shape) {
    std::set<std::array<int, 3>> faces;
    for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
        std::array<int, 3> nodes = shape.triangles[t];
        std::sort(nodes.begin(), nodes.end());
        if (!faces.insert(nodes).second)
            refuse("WetCloth: face ", t, " joins the nodes ", nodes[0], ", ", nodes[1], " and ", nodes[2],
                   ", as an earlier one does; a sheet is two-sided already, remove the double");
    }
    std::set<std::array<int, 2>> links;
    for (std::size_t i = 0; i < shape.links.size(); ++i) {
        std::array<int, 2> nodes = shape.links[i].nodes;
        std::sort(nodes.begin(), nodes.end());
        if (!links.insert(nodes).second)
            refuse("WetCloth: link ", i, " joins the nodes ", nodes[0], " and ", nodes[1],
                   ", as an earlier one does; it would be twice as stiff, remove the double");
    }
}

void checkShape(const RestShape& shape, const ClothMesh& mesh) {
    for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
        if (!(shape.triangleAreas[t] > 0))
            refuse("WetCloth: face ", t, " has no area at rest; remove it from the body");
        for (const Eigen::Vector2d& corner : mesh.coordinates[t])
            if (!corner.allFinite())
                refuse("WetCloth: the material coordinates of face ", t, " are not finite; give metres");
        const double materialArea = triangleArea(mesh.coordinates[t]);
        if (materialArea < shape.triangleAreas[t] / 3 || materialArea > shape.triangleAreas[t] * 3)
            refuse("WetCloth: face ", t, " has an area of ", sixDigits(shape.triangleAreas[t]),
                   " m2 at rest but ", sixDigits(materialArea),
                   " m2 in material coordinates; for a sheet that is not flat give "
                   "SheetSettings::materialCoordinates, for one with seams faceCoordinates, in metres");
    }
    for (std::size_t i = 0; i < shape.links.size(); ++i) {
        const auto& nodes = shape.links[i].nodes;
        if (!(shape.restLengths[i] > 0) || !std::isfinite(shape.restLengths[i]))
            refuse("WetCloth: link ", i, " between nodes ", nodes[0], " and ", nodes[1],
                   " has a rest length of ", shape.restLengths[i], " m; remove it, or set its nodes apart");
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
