// Measures wall time.
#pragma once

#include <chrono>

namespace drench::demo {

// Wall time since a time point, s.
inline double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace drench::demo
