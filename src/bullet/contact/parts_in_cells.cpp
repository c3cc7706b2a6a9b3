#include "bullet/contact/parts_in_cells.h"

#include <algorithm>
#include <cmath>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

std::size_t PartsInCells::Division::cellOf(btScalar coordinate) const {
    const btScalar cell = (coordinate - low) * perLength;
    return static_cast<std::size_t>(std::clamp(cell, btScalar(0), btScalar(count - 1)));
}

std::size_t PartsInCells::cellOf(const SolidPart& part) const {
    return rows_.cellOf(part.bounds.low[rows_.axis]) * columns_.count +
           columns_.cellOf(part.bounds.low[columns_.axis]);
}

void PartsInCells::assign(const std::vector<SolidPart>& parts, const Bounds& box) {
    const btVector3 size = box.high - box.low;
    columns_.axis = size.maxAxis();
    rows_.axis = (columns_.axis + 1) % 3;
    if (size[(columns_.axis + 2) % 3] > size[rows_.axis]) rows_.axis = (columns_.axis + 2) % 3;
    // Cells as wide as long, with two parts each on average.
    constexpr double perCell = 2, most = 256;
    const double cells = std::max(double(parts.size()) / perCell, 1.0);
    const double aspect = double(size[columns_.axis]) / std::max(double(size[rows_.axis]), 1e-9);
    columns_.count =
        static_cast<std::size_t>(std::clamp(std::sqrt(cells * aspect), 1.0, std::min(cells, most)));
    rows_.count = static_cast<std::size_t>(std::clamp(cells / double(columns_.count), 1.0, most));
    for (Division* const division : {&columns_, &rows_}) {
        const btScalar length = size[division->axis];
        division->low = box.low[division->axis];
        division->perLength = length > 0 ? btScalar(division->count) / length : 0;
        division->longest = 0;
    }
    starts_.assign(columns_.count * rows_.count + 1, 0);
    cells_.resize(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const SolidPart& part = parts[i];
        for (Division* const division : {&columns_, &rows_})
            division->longest = std::max(division->longest,
                                         part.bounds.high[division->axis] - part.bounds.low[division->axis]);
        cells_[i] = cellOf(part);
        ++starts_[cells_[i] + 1];
    }
    for (std::size_t cell = 0; cell + 1 < starts_.size(); ++cell) starts_[cell + 1] += starts_[cell];
    bounds_.resize(parts.size());
    indices_.resize(parts.size());
    next_ = starts_;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::size_t at = next_[cells_[i]]++;
        bounds_[at] = parts[i].bounds;
        indices_[at] = i;
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
