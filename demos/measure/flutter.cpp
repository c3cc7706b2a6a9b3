#include "measure/flutter.h"

#include <cmath>
#include <numeric>

#include "world/angles.h"

namespace drench::demo {

Flutter::Flutter(double interval, double window)
    : interval_(interval), max_(std::size_t(std::lround(window / interval))) {}

void Flutter::note(double value) {
    values_.push_back(value);
    if (values_.size() > max_) values_.pop_front();
}

double Flutter::mean() const {
    if (values_.empty()) return 0;
    return std::accumulate(values_.begin(), values_.end(), 0.0) / double(values_.size());
}

double Flutter::amplitude() const {
    const double middle = mean();
    double sum = 0;
    for (const double value : values_) sum += (value - middle) * (value - middle);
    return values_.empty() ? 0 : std::sqrt(sum / double(values_.size()));
}

double Flutter::frequency() const {
    const double spread = amplitude();
    if (values_.size() < 2 || !(spread > 0)) return 0;
    double sum = 0;
    for (std::size_t i = 1; i < values_.size(); ++i) {
        const double rate = (values_[i] - values_[i - 1]) / interval_;
        sum += rate * rate;
    }
    return std::sqrt(sum / double(values_.size() - 1)) / (2 * pi * spread);
}

}  // namespace drench::demo
