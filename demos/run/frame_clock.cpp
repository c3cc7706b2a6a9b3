#include "run/frame_clock.h"

#include <algorithm>

namespace drench::demo {

void FrameClock::begin(Clock::time_point now, double interval) {
    const auto wait = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(interval));
    due_ = std::max(due_, now - wait) + wait;

    constexpr double counting = 0.5;  // s
    ++counted_;
    const double since = std::chrono::duration<double>(now - countedFrom_).count();
    if (since < counting) return;
    rate_ = counted_ / since;
    counted_ = 0;
    countedFrom_ = now;
}

}  // namespace drench::demo
