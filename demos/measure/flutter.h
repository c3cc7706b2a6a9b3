// How fast and how far something goes to and fro.
#pragma once

#include <deque>

namespace drench::demo {

// The last seconds of a quantity that was noted at equal intervals.
class Flutter {
  public:
    // @param interval  between two notes, s
    // @param window    how far back it remembers, s
    Flutter(double interval, double window);

    void note(double value);

    double mean() const;
    // Root mean square about the mean.
    double amplitude() const;
    // How often it passes its mean upwards, 1/s: the root mean square of its rate over that of itself, over
    // 2 pi (Rice 1944). Counting the passes of a few seconds of flapping would scatter twice as much.
    double frequency() const;

  private:
    double interval_;
    std::size_t max_;
    std::deque<double> values_;
};

}  // namespace drench::demo
