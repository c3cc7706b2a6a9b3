// Finds the object under the mouse pointer.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "viewer/picture/picture.h"

namespace drench::viewer {

// A ray into the picture.
struct Ray {
    Eigen::Vector3f origin = Eigen::Vector3f::Zero();
    // Unit vector.
    Eigen::Vector3f direction = -Eigen::Vector3f::UnitZ();
};

// The ray from the camera through a point of a picture `aspect` times as wide as high; x from 0 (left) to 1
// (right), y from 0 (top) to 1 (bottom).
Ray rayThrough(const Camera& camera, float aspect, float x, float y);

// Distance of a triangle along the ray, from either side; none if the ray misses it.
std::optional<float> distanceTo(const Ray& ray, const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                                const Eigen::Vector3f& c);

// Distance of the nearest ball along the ray; none if the ray misses all.
std::optional<float> distanceToBalls(const Ray& ray, const std::vector<Ball>& balls);

// Whether the ray hits a sheet before any ball.
bool meetsSheet(const Ray& ray, const Picture& picture);

}  // namespace drench::viewer
