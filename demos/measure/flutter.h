// Frequency and amplitude of an oscillation.
#pragma once

#include <deque>

namespace drench::demo {

// The last seconds of a quantity that is recorded at equal intervals.
class Flutter {
  public:
    // @param interval  between two values, s
    // @param window    duration that is kept, s
    Flutter(double interval, double window);

    void note(double value);

    double mean() const;
    // Root mean square about the mean.
    double amplitude() const;
    // Frequency of upward crossings of the mean, 1/s: the root mean square of the rate of change over that of
    // the value, over 2 pi (Rice 1944). Counting crossings in a few seconds of flapping would have twice the
    // scatter.
    double frequency() const;

  private:
    double interval_;
    std::size_t max_;
    std::deque<double> values_;
};

}  // namespace drench::demo
