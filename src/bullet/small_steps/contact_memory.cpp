#include "bullet/small_steps/contact_memory.h"

#include <algorithm>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

void ContactMemory::sort() {
    std::stable_sort(contacts_.begin(), contacts_.end(),
                     [](const Contact& a, const Contact& b) { return a.node < b.node; });
}

std::vector<ContactMemory::Contact>::const_iterator ContactMemory::firstOf(int node) const {
    return std::lower_bound(contacts_.begin(), contacts_.end(), node,
                            [](const Contact& each, int of) { return each.node < of; });
}

bool ContactMemory::shareNode(const std::array<int, 3>& corners, const std::array<int, 3>& others) {
    return std::find_first_of(corners.begin(), corners.end(), others.begin(), others.end()) != corners.end();
}

const ContactMemory::Contact* ContactMemory::ofFace(int node, const btSoftBody& other,
                                                    const std::array<int, 3>& corners) const {
    const Contact *same = nullptr, *adjacent = nullptr;
    forFacesOf(node, other, [&](const Contact& each) {
        if (!same && each.corners == corners) same = &each;
        if (!adjacent && shareNode(corners, each.corners)) adjacent = &each;
    });
    return same ? same : adjacent;
}

const ContactMemory::Contact* ContactMemory::ofEdges(int node, int otherEnd, const btSoftBody& other,
                                                     int from, int to) const {
    for (auto each = firstOf(node); each != contacts_.end() && each->node == node; ++each)
        if (each->other == &other && each->otherEnd == otherEnd && each->corners[0] == from &&
            each->corners[1] == to)
            return &*each;
    return nullptr;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
