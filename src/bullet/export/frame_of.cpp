#include "drench/files/cloth_frame.h"

#include <BulletSoftBody/btSoftBody.h>

#include <Eigen/Geometry>

#include "checks/checks.h"
#include "drench/wet_cloth.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// The normal of a node without a triangle of an area above 0 points up.
std::vector<Eigen::Vector3f> normalsOf(const ClothFrame& frame) {
    std::vector<Eigen::Vector3f> normals(frame.positions.size(), Eigen::Vector3f::Zero());
    const auto at = [](int node) { return static_cast<std::size_t>(node); };
    for (const auto& triangle : frame.triangles) {
        const Eigen::Vector3f& origin = frame.positions[at(triangle[0])];
        const Eigen::Vector3f across =
            (frame.positions[at(triangle[1])] - origin).cross(frame.positions[at(triangle[2])] - origin);
        for (const int node : triangle) normals[at(node)] += across;
    }
    for (Eigen::Vector3f& normal : normals) {
        const float length = normal.stableNorm();
        normal = length > 0 ? Eigen::Vector3f(normal / length) : Eigen::Vector3f::UnitY();
    }
    return normals;
}

void readShape(ClothFrame& frame, const btSoftBody& body) {
    for (int f = 0; f < body.m_faces.size(); ++f) {
        std::array<int, 3>& triangle = frame.triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
            triangle[k] = static_cast<int>(body.m_faces[f].m_n[k] - &body.m_nodes[0]);
    }
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        const btVector3& x = body.m_nodes[n].m_x;
        frame.positions.emplace_back(float(x.x()), float(x.y()), float(x.z()));
    }
    frame.normals = normalsOf(frame);
}

void readWater(ClothFrame& frame, const WetCloth& cloth) {
    const Moisture& moisture = cloth.moisture();
    frame.poreMasses = moisture.poreMass();
    frame.filmMasses = moisture.filmMass();
    for (std::size_t node = 0; node < moisture.size(); ++node) {
        const int n = static_cast<int>(node);
        frame.masses.push_back(cloth.nodeMass(n));
        frame.filmThicknesses.push_back(moisture.filmThickness(node));
        frame.moistureContents.push_back(cloth.moistureContent(n));
        frame.saturations.push_back(float(cloth.saturation(n)));
        frame.glosses.push_back(float(cloth.gloss(n)));
        const Colour colour = cloth.albedo(n);
        frame.colours.emplace_back(float(colour[0]), float(colour[1]), float(colour[2]));
    }
}

}  // namespace

ClothFrame frameOf(const std::string& name, const btSoftBody& body, const WetCloth& cloth) {
    ClothFrame frame;
    frame.name = name;
    if (static_cast<std::size_t>(body.m_nodes.size()) != cloth.moisture().size())
        refuse("sheet ", inQuotes(name), ": the body has ", body.m_nodes.size(), " nodes and the cloth ",
               cloth.moisture().size(), "; give the body that the cloth is attached to");
    readShape(frame, body);
    readWater(frame, cloth);
    validate(frame);
    return frame;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
