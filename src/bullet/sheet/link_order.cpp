#include "bullet/sheet/link_order.h"

#include <algorithm>
#include <cstdint>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

std::vector<int> colouredOrder(const std::vector<std::array<int, 2>>& links, int nodes) {
    // Greedy edge colouring. A node with more than 64 links, which no cloth has, shares the last colour.
    constexpr std::size_t lastColour = 63;
    std::vector<std::uint64_t> coloursAt(static_cast<std::size_t>(nodes), 0);
    std::vector<std::vector<int>> linksOf;
    for (std::size_t i = 0; i < links.size(); ++i) {
        std::uint64_t& atA = coloursAt[static_cast<std::size_t>(links[i][0])];
        std::uint64_t& atB = coloursAt[static_cast<std::size_t>(links[i][1])];
        std::size_t colour = 0;
        while (colour < lastColour && ((atA | atB) >> colour & 1u)) ++colour;
        atA |= std::uint64_t{1} << colour;
        atB |= std::uint64_t{1} << colour;
        if (colour >= linksOf.size()) linksOf.resize(colour + 1);
        linksOf[colour].push_back(static_cast<int>(i));
    }
    std::vector<int> order;
    order.reserve(links.size());
    for (const auto& colour : linksOf) order.insert(order.end(), colour.begin(), colour.end());
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
