// Finds parts of a solid by place.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "bullet/contact/solid_parts.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// The parts in a box, in cells along its two longest axes, so that those near a point are few, and rows of them side by
// side in memory.
class PartsInCells {
  public:
    // Sorts parts. @param box  that all of them meet
    void assign(const std::vector<SolidPart>& parts, const Bounds& box);

    // Calls `each(index)` for the parts whose bounds meet a box.
    template <typename Each>
    void forEach(const Bounds& box, Each each) const {
        const std::size_t first = columns_.cellOf(box.low[columns_.axis] - columns_.longest),
                          last = columns_.cellOf(box.high[columns_.axis]);
        const std::size_t end = rows_.cellOf(box.high[rows_.axis]);
        for (std::size_t row = rows_.cellOf(box.low[rows_.axis] - rows_.longest); row <= end; ++row) {
            const std::size_t cells = row * columns_.count;
            for (std::size_t i = starts_[cells + first]; i < starts_[cells + last + 1]; ++i)
                if (bounds_[i].meets(box)) each(indices_[i]);
        }
    }

  private:
    // The cells along an axis.
    struct Division {
        int axis = 0;
        std::size_t count = 1;
        btScalar low = 0, perLength = 0;  // m and 1/m
        btScalar longest = 0;             // extent of a part along the axis, m

        std::size_t cellOf(btScalar coordinate) const;
    };
    std::size_t cellOf(const SolidPart& part) const;

    Division columns_, rows_;
    std::vector<Bounds> bounds_;
    std::vector<std::size_t> indices_;
    std::vector<std::size_t> starts_;        // first part of each cell, by its lower bounds
    std::vector<std::size_t> cells_, next_;  // while parts are sorted
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
