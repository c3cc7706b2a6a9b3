// Schedules frames in wall time, and measures the frame rate.
#pragma once

#include <chrono>

namespace drench::demo {

// Frames at regular intervals of wall time. Delays are not caught up, so that nothing runs too fast after a
// pause.
class FrameClock {
  public:
    using Clock = std::chrono::steady_clock;

    // @param start  earliest time of the first frame
    explicit FrameClock(Clock::time_point start) : due_(start), countedFrom_(start) {}

    // Earliest time of the next frame.
    Clock::time_point due() const { return due_; }
    // Registers the start of a frame. @param interval  s until the next one is due; 0: at once
    void begin(Clock::time_point now, double interval);
    // Frames per second over about the last half second; 0 before.
    double rate() const { return rate_; }

  private:
    Clock::time_point due_;
    Clock::time_point countedFrom_;
    int counted_ = 0;
    double rate_ = 0;
};

}  // namespace drench::demo
