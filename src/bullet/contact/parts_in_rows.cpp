#include "bullet/contact/parts_in_rows.h"

#include <algorithm>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

std::size_t PartsInRows::rowOf(btScalar coordinate) const {
    const btScalar row = (coordinate - low_) * perLength_;
    return static_cast<std::size_t>(std::clamp(row, btScalar(0), btScalar(rows - 1)));
}

void PartsInRows::assign(const std::vector<SolidPart>& parts, const Bounds& box) {
    const btVector3 size = box.high - box.low;
    axis_ = size.maxAxis();
    low_ = box.low[axis_];
    perLength_ = size[axis_] > 0 ? btScalar(rows) / size[axis_] : 0;
    longest_ = 0;
    starts_.fill(0);
    for (const SolidPart& part : parts) {
        longest_ = std::max(longest_, part.bounds.high[axis_] - part.bounds.low[axis_]);
        ++starts_[rowOf(part.bounds.low[axis_]) + 1];
    }
    for (std::size_t row = 0; row < rows; ++row) starts_[row + 1] += starts_[row];
    bounds_.resize(parts.size());
    indices_.resize(parts.size());
    std::array<std::size_t, rows + 1> next = starts_;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::size_t at = next[rowOf(parts[i].bounds.low[axis_])]++;
        bounds_[at] = parts[i].bounds;
        indices_[at] = i;
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
