#include "drench/files/cloth_frame.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "checks/checks.h"

namespace drench {

namespace {

template <typename... Parts>
[[noreturn]] void refuseFrame(const ClothFrame& frame, const Parts&... parts) {
    refuse("sheet ", inQuotes(frame.name), ": ", parts...);
}

bool isFinite(double value) {
    return std::isfinite(value);
}
bool isFinite(const Eigen::Vector3f& value) {
    return value.allFinite();
}

template <typename Value>
void checkList(const ClothFrame& frame, const char* name, const std::vector<Value>& values) {
    if (values.size() != frame.positions.size())
        refuseFrame(frame, "there are ", frame.positions.size(), " positions and ", values.size(), ' ', name,
                    "; give one of each for a node");
    for (std::size_t node = 0; node < values.size(); ++node)
        if (!isFinite(values[node]))
            refuseFrame(frame, name, " of node ", node,
                        " are not finite; the run has gone wrong before this frame");
}

void checkName(const ClothFrame& frame) {
    constexpr std::size_t longest = 64;
    const bool isPlain = std::all_of(frame.name.begin(), frame.name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' ||
               c == '-' || c == '_';
    });
    if (frame.name.empty() || frame.name.size() > longest || !isPlain)
        refuseFrame(frame, "give it a name of 1 to 64 letters, digits, blanks, - or _");
}

bool isMesh(const ClothFrame& frame) {
    const auto isThere = [&](int node) {
        return node >= 0 && static_cast<std::size_t>(node) < frame.positions.size();
    };
    return !frame.triangles.empty() &&
           std::all_of(frame.triangles.begin(), frame.triangles.end(), [&](const auto& triangle) {
               return std::all_of(triangle.begin(), triangle.end(), isThere);
           });
}

/// A node that no triangle with an area has looks up.
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
    checkList(frame, "positions", frame.positions);
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
        frame.contents.push_back(cloth.content(n));
        frame.saturations.push_back(float(cloth.saturation(n)));
        frame.glosses.push_back(float(cloth.gloss(n)));
        const Colour colour = cloth.albedo(n);
        frame.colours.emplace_back(float(colour[0]), float(colour[1]), float(colour[2]));
    }
}

}  // namespace

void validate(const ClothFrame& frame) {
    checkName(frame);
    if (!isMesh(frame)) refuseFrame(frame, "it has no triangles, or one with a node that is not there");
    checkList(frame, "positions", frame.positions);
    checkList(frame, "normals", frame.normals);
    checkList(frame, "masses", frame.masses);
    checkList(frame, "poreMasses", frame.poreMasses);
    checkList(frame, "filmMasses", frame.filmMasses);
    checkList(frame, "filmThicknesses", frame.filmThicknesses);
    checkList(frame, "contents", frame.contents);
    checkList(frame, "saturations", frame.saturations);
    checkList(frame, "glosses", frame.glosses);
    checkList(frame, "colours", frame.colours);
}

inline namespace DRENCH_BULLET_NAMESPACE {

ClothFrame frameOf(const std::string& name, const btSoftBody& body, const WetCloth& cloth) {
    ClothFrame frame;
    frame.name = name;
    if (static_cast<std::size_t>(body.m_nodes.size()) != cloth.moisture().size())
        refuseFrame(frame, "the body has ", body.m_nodes.size(), " nodes and the cloth ",
                    cloth.moisture().size(), "; give the body that the cloth is attached to");
    readShape(frame, body);
    readWater(frame, cloth);
    validate(frame);
    return frame;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
