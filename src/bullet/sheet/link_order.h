// The order in which Bullet's sweeps meet the links of a body.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <array>
#include <vector>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// An order in which links come in colours: no two links of a colour share a node. In mesh order each link
// would hand on what the one before it did, and hard links blow up.
// @param links  the two nodes of each link
// @return for each place in the order, the index of the link that goes there; links that come in colours
// already
//         keep their places
std::vector<int> colouredOrder(const std::vector<std::array<int, 2>>& links, int nodes);

// Puts the link that is at order[i] at i, with all that belongs to it.
void reorderLinks(btSoftBody& body, const std::vector<int>& order);

// The order that undoes another.
std::vector<int> inverseOrder(const std::vector<int>& order);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
