// How fast pictures come.
#pragma once

#include <chrono>
#include <iosfwd>

namespace drench::demo {

/// Counts the pictures of a window, for the line that --timings asks for.
class PictureCount {
  public:
    using Clock = std::chrono::steady_clock;

    /// @param start  of the program
    explicit PictureCount(Clock::time_point start) : start_(start) {}

    /// Notes that a picture is on the screen.
    void note();
    /// Writes when the first picture came, and how many there were a second after that.
    void report(std::ostream& out) const;

  private:
    Clock::time_point start_;
    Clock::time_point first_;
    Clock::time_point last_;
    int count_ = 0;
};

}  // namespace drench::demo
