#include "viewer/picture/picking.h"

#include <cmath>
#include <limits>

namespace drench::viewer {

Ray rayThrough(const Camera& camera, float aspect, float x, float y) {
    const float halfHeight = std::tan(camera.verticalFieldOfView / 2.0f);
    const Eigen::Vector3f up = camera.right().cross(camera.forward());
    const Eigen::Vector3f direction = camera.forward() +
                                      (2.0f * x - 1.0f) * aspect * halfHeight * camera.right() +
                                      (1.0f - 2.0f * y) * halfHeight * up;
    return {camera.eye(), direction.normalized()};
}

// Moeller and Trumbore 1997.
std::optional<float> distanceTo(const Ray& ray, const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                                const Eigen::Vector3f& c) {
    const Eigen::Vector3f ab = b - a, ac = c - a;
    const Eigen::Vector3f across = ray.direction.cross(ac);
    const float volume = ab.dot(across);
    if (!(std::abs(volume) > 1e-12f)) return std::nullopt;
    const Eigen::Vector3f from = ray.origin - a;
    const float u = from.dot(across) / volume;
    const Eigen::Vector3f turned = from.cross(ab);
    const float v = ray.direction.dot(turned) / volume;
    const float distance = ac.dot(turned) / volume;
    if (!(u >= 0.0f && v >= 0.0f && u + v <= 1.0f && distance > 0.0f)) return std::nullopt;
    return distance;
}

std::optional<float> distanceToBalls(const Ray& ray, const std::vector<Ball>& balls) {
    std::optional<float> nearest;
    for (const Ball& ball : balls) {
        const Eigen::Vector3f from = ray.origin - ball.centre;
        const float along = from.dot(ray.direction);
        const float inside = along * along - from.squaredNorm() + ball.radius * ball.radius;
        if (!(inside >= 0.0f)) continue;
        const float distance = -along - std::sqrt(inside);
        if (distance > 0.0f && (!nearest || distance < *nearest)) nearest = distance;
    }
    return nearest;
}

bool meetsSheet(const Ray& ray, const Picture& picture) {
    const float max = distanceToBalls(ray, picture.balls).value_or(std::numeric_limits<float>::infinity());
    for (const SheetMesh& sheet : picture.sheets) {
        for (const auto& triangle : sheet.triangles) {
            const auto distance = distanceTo(ray, sheet.positions[triangle[0]], sheet.positions[triangle[1]],
                                             sheet.positions[triangle[2]]);
            // Cloth on a ball may be at the same distance, within a tolerance.
            constexpr float onIt = 0.02f;
            if (distance && *distance < max + onIt) return true;
        }
    }
    return false;
}

}  // namespace drench::viewer
