#include "bullet/small_steps/contact_memory.h"

#include <algorithm>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

bool has(const std::array<int, 3>& corners, int node) {
    return node >= 0 && std::find(corners.begin(), corners.end(), node) != corners.end();
}

}  // namespace

void ContactMemory::sort() {
    std::stable_sort(contacts_.begin(), contacts_.end(),
                     [](const Contact& a, const Contact& b) { return a.node < b.node; });
}

const ContactMemory::Contact* ContactMemory::ofFace(int node, const btSoftBody& other,
                                                    const std::array<int, 3>& corners) const {
    const Contact* adjacent = nullptr;
    const auto first = std::lower_bound(contacts_.begin(), contacts_.end(), node,
                                        [](const Contact& each, int of) { return each.node < of; });
    for (auto each = first; each != contacts_.end() && each->node == node; ++each) {
        if (each->other != &other || each->otherEnd >= 0) continue;
        if (each->corners == corners) return &*each;
        const auto isShared = [&](int corner) { return has(each->corners, corner); };
        if (!adjacent && std::any_of(corners.begin(), corners.end(), isShared)) adjacent = &*each;
    }
    return adjacent;
}

const ContactMemory::Contact* ContactMemory::ofEdges(int node, int otherEnd, const btSoftBody& other,
                                                     int from, int to) const {
    const auto first = std::lower_bound(contacts_.begin(), contacts_.end(), node,
                                        [](const Contact& each, int of) { return each.node < of; });
    for (auto each = first; each != contacts_.end() && each->node == node; ++each)
        if (each->other == &other && each->otherEnd == otherEnd && each->corners[0] == from &&
            each->corners[1] == to)
            return &*each;
    return nullptr;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
