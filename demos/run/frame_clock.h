// When frames are due, and how many there were lately.
#pragma once

#include <chrono>

namespace drench::demo {

// Frames at an even pace of wall time. One that comes late is not made up for, so that nothing rushes after a
// pause.
class FrameClock {
  public:
    using Clock = std::chrono::steady_clock;

    // @param start  from when on the first frame may begin
    explicit FrameClock(Clock::time_point start) : due_(start), countedFrom_(start) {}

    // The moment from which the next frame may begin.
    Clock::time_point due() const { return due_; }
    // Notes that a frame begins. @param interval  s until the next is due; 0: at once
    void begin(Clock::time_point now, double interval);
    // Frames a second over the last half second or so; 0 before.
    double rate() const { return rate_; }

  private:
    Clock::time_point due_;
    Clock::time_point countedFrom_;
    int counted_ = 0;
    double rate_ = 0;
};

}  // namespace drench::demo
