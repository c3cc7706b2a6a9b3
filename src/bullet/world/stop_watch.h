// Measures computing time.
#pragma once

#include <chrono>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Starts at construction.
class StopWatch {
  public:
    // Time since the last lap, s.
    double lap() {
        const Clock::time_point now = Clock::now();
        const double took = std::chrono::duration<double>(now - from_).count();
        from_ = now;
        return took;
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point from_ = Clock::now();
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
