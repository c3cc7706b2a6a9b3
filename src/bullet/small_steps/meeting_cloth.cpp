#include "bullet/small_steps/meeting_cloth.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

void MeetingCloth::startMotion() {
    movedBefore.assign(moved, moved + tree->nodeCount());
    way.setZero();
    deviations = 0;
    isFollowed = false;
    followNodes();
}

// The box of the displacements tells how far any may be from their middle.
void MeetingCloth::measureMotion() {
    constexpr float far = std::numeric_limits<float>::infinity();
    Eigen::Array4f low = Eigen::Array4f::Constant(far), high = -low;
    for (std::size_t n = 0; n < movedBefore.size(); ++n) {
        const Eigen::Map<const Eigen::Array4f> now(&moved[n].x);
        Eigen::Map<Eigen::Array4f> before(&movedBefore[n].x);
        const Eigen::Array4f by = now - before;
        before = now;
        low = low.min(by);
        high = high.max(by);
    }
    meanStep = ((low + high) / 2).head<3>().matrix();
    growth = ((high - low) / 2).head<3>().matrix().norm();
    way += meanStep;
    deviations += growth;
    isFollowed = false;
}

void MeetingCloth::followNodes() {
    if (!std::exchange(isFollowed, true)) tree->follow(start, moved);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
