// State of a sheet at one moment as arrays of numbers, for files and other programs.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "drench/config.h"

class btSoftBody;

namespace drench {

/// Geometry, water and colours of a sheet. Each array except `triangles` has one entry per node.
struct ClothFrame {
    std::string name;                           ///< of the sheet; not empty
    std::vector<std::array<int, 3>> triangles;  ///< node indices
    std::vector<Eigen::Vector3f> positions;     ///< m
    std::vector<Eigen::Vector3f>
        normals;                          ///< unit vectors, area-weighted over the triangles; +y if undefined
    std::vector<double> masses;           ///< of cloth and water, kg
    std::vector<double> poreMasses;       ///< pore water, kg
    std::vector<double> filmMasses;       ///< film water, both faces together, kg
    std::vector<double> filmThicknesses;  ///< of the film on one face, m
    std::vector<double> moistureContents;  ///< kg of water per kg of dry cloth
    std::vector<float> saturations;        ///< pore water over pore capacity, 0 to 1
    std::vector<float> glosses;            ///< fraction that is glossy like water, 0 to 1
    std::vector<Eigen::Vector3f> colours;  ///< diffuse, linear RGB, 0 to 1
};

/// Checks that a frame has a name and triangles, arrays of equal length, valid node indices, and finite numbers.
/// @throws std::invalid_argument that names the sheet, the array and the node
DRENCH_API void validate(const ClothFrame& frame);

inline namespace DRENCH_BULLET_NAMESPACE {

class WetCloth;

/// The present state of a sheet.
/// @param name  1 to 64 letters, digits, spaces, - or _
/// @param body  the body of `cloth`
/// @throws std::invalid_argument for an invalid name, a body whose number of nodes differs from the cloth's, or a
///     number that is not finite
DRENCH_API ClothFrame frameOf(const std::string& name, const btSoftBody& body, const WetCloth& cloth);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
