// Finds parts of a solid by place.
#pragma once

#include <array>
#include <vector>

#include "bullet/contact/solid_parts.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// The parts in a box, in rows across its longest axis, so that those near a point are few and side by side in memory.
class PartsInRows {
  public:
    // Sorts parts. @param box  that all of them meet
    void assign(const std::vector<SolidPart>& parts, const Bounds& box);

    // Calls `each(index)` for the parts whose bounds meet a box.
    template <typename Each>
    void forEach(const Bounds& box, Each each) const {
        const std::size_t end = starts_[rowOf(box.high[axis_]) + 1];
        for (std::size_t i = starts_[rowOf(box.low[axis_] - longest_)]; i < end; ++i)
            if (bounds_[i].meets(box)) each(indices_[i]);
    }

  private:
    static constexpr std::size_t rows = 32;
    std::size_t rowOf(btScalar coordinate) const;

    int axis_ = 0;
    btScalar low_ = 0, perLength_ = 0;  // m and 1/m
    btScalar longest_ = 0;              // extent of a part along the axis, m
    std::vector<Bounds> bounds_;
    std::vector<std::size_t> indices_;
    std::array<std::size_t, rows + 1> starts_;  // first part of each row, by its lower bound
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
