#include "viewer/passes/box_mesh.h"

namespace drench::viewer {

BoxMesh boxMesh() {
    BoxMesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            for (const auto& [across, along] : {std::array{-1.0f, -1.0f}, std::array{1.0f, -1.0f},
                                                std::array{1.0f, 1.0f}, std::array{-1.0f, 1.0f}}) {
                Eigen::Vector4f corner;
                corner[axis] = side;
                corner[(axis + 1) % 3] = across;
                corner[(axis + 2) % 3] = along;
                corner[3] = static_cast<float>(axis);
                mesh.vertices.push_back(corner);
            }
            mesh.triangles.push_back({first, first + 1, first + 2});
            mesh.triangles.push_back({first, first + 2, first + 3});
        }
    }
    return mesh;
}

}  // namespace drench::viewer
