// Recognises sheets and worlds whose numbers are not in metres, kilograms and seconds.
#pragma once

#include <Eigen/Core>
#include <string>

#include "drench/cloth_mesh.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// What tells the unit of a world.
struct ScaleSigns {
    Eigen::Vector2d size;  // of the sheet's material coordinates, m
    double meanLink;       // m
    double mass;           // of the dry sheet, kg
    double gravity;        // m/s2
};

// Width and height of the material coordinates, m.
Eigen::Vector2d materialSize(const ClothMesh& mesh);

// What looks like another unit, and how to correct it; empty if nothing does. Signs are a gravity of the
// earth's in another unit of length or above 100 m/s2, a sheet longer than 50 m or shorter than
// 1 cm, and links below 0.1 mm. All other gravities are possible: none, in a lift, and of the moon to Jupiter.
std::string wrongUnit(const ScaleSigns& signs);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
