#include "window/picture_count.h"

#include <iomanip>
#include <ostream>

namespace drench::demo {

void PictureCount::note() {
    last_ = Clock::now();
    if (count_++ == 0) first_ = last_;
}

void PictureCount::report(std::ostream& out) const {
    if (count_ == 0) {
        out << "no picture\n";
        return;
    }
    const auto seconds = [](Clock::duration time) { return std::chrono::duration<double>(time).count(); };
    out << std::fixed << std::setprecision(2) << "first picture after " << seconds(first_ - start_) << " s";
    if (count_ > 1)
        out << ", then " << std::setprecision(1) << (count_ - 1) / seconds(last_ - first_)
            << " pictures a second";
    out << '\n';
}

}  // namespace drench::demo
