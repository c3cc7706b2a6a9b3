// Constants that several folders use.
#pragma once

namespace drench {

inline constexpr double pi = 3.14159265358979323846;

}  // namespace drench
