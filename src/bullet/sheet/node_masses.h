// Writes the mass of cloth and water into a body's nodes.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "drench/precision.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// Water that has reached a node since the last substep.
struct Arrival {
    double carried = 0;                       // kg that move with the node, whatever its velocity
    double mass = 0;                          // kg that came with a velocity of their own
    btVector3 momentum = btVector3(0, 0, 0);  // of these, kg m/s
};

/// Lets each free node take up the momentum of the water that arrived: v <- (m v + dm u) / (m + dm). Water
/// that leaves takes its own momentum along, so a node that only loses mass keeps its velocity. Empties
/// `arrivals`.
/// @param masses  of the nodes before the water came, kg
void takeUpMomentum(btSoftBody& body, const std::vector<double>& masses, std::vector<Arrival>& arrivals);

/// Sets inverse masses; pins stay pins.
void writeMasses(btSoftBody& body, const std::vector<double>& masses);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
