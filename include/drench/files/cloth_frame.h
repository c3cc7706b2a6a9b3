// A sheet at one moment as plain numbers, for files and other programs.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "drench/export.h"
#include "drench/precision.h"

class btSoftBody;

namespace drench {

/// What there is to see and to measure of a sheet. Each list but `triangles` has one entry a node.
struct ClothFrame {
    std::string name;
    std::vector<std::array<int, 3>> triangles;  ///< node indices
    std::vector<Eigen::Vector3f> positions;     ///< m
    std::vector<Eigen::Vector3f> normals;  ///< of length 1: of the triangles around, by their areas; or +y
    std::vector<double> masses;            ///< cloth and water, kg
    std::vector<double> poreMasses;        ///< water between the fibres, kg
    std::vector<double> filmMasses;        ///< water on both faces, kg
    std::vector<double> filmThicknesses;   ///< on one face, m
    std::vector<double> contents;          ///< water over dry cloth, kg/kg
    std::vector<float> saturations;        ///< pore water over pore capacity, 0 to 1
    std::vector<float> glosses;            ///< how much a node shines like water, 0 to 1
    std::vector<Eigen::Vector3f> colours;  ///< diffuse, linear RGB, 0 to 1: wet cloth is darker
};

/// Checks that a frame has a name and triangles, that lists are as long as each other, that nodes of triangles are there,
/// and that every number is finite.
/// @throws std::invalid_argument that names the sheet, the list and the node
DRENCH_API void validate(const ClothFrame& frame);

inline namespace DRENCH_BULLET_NAMESPACE {

class WetCloth;

/// The sheet as it is now.
/// @param name  of 1 to 64 letters, digits, blanks, - or _, so that it may stand in any file
/// @param body  that `cloth` is attached to
/// @throws std::invalid_argument for another name, a body of another number of nodes than the cloth, and where a
///     position or another number is not finite
DRENCH_API ClothFrame frameOf(const std::string& name, const btSoftBody& body, const WetCloth& cloth);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
