#include "bullet/small_steps/meeting_cloth.h"

#include <algorithm>
#include <limits>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// The box of the displacements tells how far any may be from their middle.
void MeetingCloth::measureMotion() {
    constexpr float far = std::numeric_limits<float>::infinity();
    Eigen::Array4f low = Eigen::Array4f::Constant(far), high = -low;
    for (std::size_t n = 0; n < movedAt.size(); ++n) {
        const Eigen::Array4f by =
            Eigen::Map<const Eigen::Array4f>(&moved[n].x) - Eigen::Map<const Eigen::Array4f>(&movedAt[n].x);
        low = low.min(by);
        high = high.max(by);
    }
    const Eigen::Vector3f middle = ((low + high) / 2).head<3>().matrix();
    const float farthest = ((high - low) / 2).head<3>().matrix().norm();
    growth = std::max(0.0f, farthest - deviation);
    meanStep = middle - mean;
    mean = middle;
    deviation = farthest;
}

void MeetingCloth::restartMotion() {
    movedAt.assign(moved, moved + tree->nodeCount());
    mean.setZero();
    deviation = 0;
    isDue = false;
    tree->follow(start, moved);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
