#include "bullet/sheet/layer_touches.h"

#include <algorithm>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

void LayerTouches::begin() {
    others.clear();
    contacts.clear();
    areListed = true;
}

int LayerTouches::numberOf(const btSoftBody& other) {
    auto found = std::find(others.begin(), others.end(), &other);
    if (found == others.end()) found = others.insert(others.end(), &other);
    return static_cast<int>(found - others.begin()) + 1;
}

// The number stays, so that those of the others need not change.
void LayerTouches::forget(const btSoftBody& other) {
    const auto found = std::find(others.begin(), others.end(), &other);
    if (found == others.end()) return;
    const int with = static_cast<int>(found - others.begin()) + 1;
    contacts.erase(std::remove_if(contacts.begin(), contacts.end(),
                                  [&](const LayerContact& contact) { return contact.with == with; }),
                   contacts.end());
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
