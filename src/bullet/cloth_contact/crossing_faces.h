// Whether two faces, or an edge and a face, cross.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

namespace drench {

using FaceCorners = std::array<Eigen::Vector3d, 3>;  // m

// Whether two faces have a point in common; to touch is to cross. Faces in one plane cross where they overlap.
// The signs of volumes decide (Guigue and Devillers, "Fast and robust triangle-triangle overlap test using orientation
// predicates", 2003), without tolerance and for coordinates in single precision without rounding.
bool facesCross(const FaceCorners& one, const FaceCorners& other);

// Where an edge passes through a face.
struct EdgeThroughFace {
    double along;             // how far along the edge, 0 to 1
    Eigen::Vector3d weights;  // barycentric coordinates in the face
};
// None if it does not pass, or lies in the plane of the face.
std::optional<EdgeThroughFace> edgeThroughFace(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                               const FaceCorners& face);

}  // namespace drench
