// What lies under the mouse pointer.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "viewer/picture/picture.h"

namespace drench::viewer {

// A half line into the picture.
struct Ray {
    Eigen::Vector3f origin = Eigen::Vector3f::Zero();
    // Of unit length.
    Eigen::Vector3f direction = -Eigen::Vector3f::UnitZ();
};

// The ray from the eye through a point of a picture `aspect` times as wide as high; x from 0 (left) to 1
// (right), y from 0 (top) to 1 (bottom).
Ray rayThrough(const Camera& camera, float aspect, float x, float y);

// How far along the ray a triangle is, from either side; none if the ray misses it.
std::optional<float> distanceTo(const Ray& ray, const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                                const Eigen::Vector3f& c);

// How far along the ray the nearest ball is; none if the ray misses all.
std::optional<float> distanceToBalls(const Ray& ray, const std::vector<Ball>& balls);

// Whether a sheet is what the ray meets first, with balls before it in its way.
bool meetsSheet(const Ray& ray, const Picture& picture);

}  // namespace drench::viewer
