#include "bullet/sheet/link_order.h"

#include <algorithm>
#include <numeric>

#include "cloth/independent_sets.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

std::vector<int> colouredOrder(const std::vector<std::array<int, 2>>& links, int nodes) {
    // Nodes with more than 64 links, which do not occur in cloth, share the last colour.
    constexpr int lastColour = 63;
    IndependentSets colours(links, static_cast<std::size_t>(nodes));
    std::vector<int> waiting(links.size()), order;
    std::iota(waiting.begin(), waiting.end(), 0);
    order.reserve(links.size());
    for (int colour = 0; colour < lastColour && !waiting.empty(); ++colour) {
        const std::vector<int> taken = colours.take(waiting);
        order.insert(order.end(), taken.begin(), taken.end());
    }
    order.insert(order.end(), waiting.begin(), waiting.end());
    return order;
}

void reorderLinks(btSoftBody& body, const std::vector<int>& order) {
    if (std::is_sorted(order.begin(), order.end())) return;
    btSoftBody::tLinkArray before;
    before.copyFromArray(body.m_links);
    for (int i = 0; i < body.m_links.size(); ++i)
        body.m_links[i] = before[order[static_cast<std::size_t>(i)]];
}

std::vector<int> inverseOrder(const std::vector<int>& order) {
    std::vector<int> inverse(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        inverse[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    return inverse;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
