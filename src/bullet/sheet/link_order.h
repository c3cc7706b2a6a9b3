// The order in which Bullet's sweeps solve the links of a body.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <array>
#include <vector>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Sorts links by graph colouring: no two links of a colour share a node. In mesh order each link passes on
// the correction of the link before it, and stiff links diverge.
// @param links  the two nodes of each link
// @return for each position in the new order, the index of the link; links that are already sorted by colour
//     keep their positions
std::vector<int> colouredOrder(const std::vector<std::array<int, 2>>& links, int nodes);

// Moves the link at order[i] to index i, with all its data.
void reorderLinks(btSoftBody& body, const std::vector<int>& order);

// The inverse permutation.
std::vector<int> inverseOrder(const std::vector<int>& order);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
