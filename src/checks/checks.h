// Checks of settings, with messages that name the setting, its value, and what to give instead.
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>
#include <string_view>

#include "checks/text.h"

namespace drench {

// Of the messages of all exceptions that Drench throws itself.
inline constexpr std::string_view messagePrefix = "drench: ";

// @throws Error with a message of these parts, after the prefix
template <typename Error = std::invalid_argument, typename... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
    throw Error(textOf(messagePrefix, parts...));
}

// A message without the "drench: " before it.
std::string withoutPrefix(std::string_view message);
inline std::string reasonOf(const std::exception& problem) {
    return withoutPrefix(problem.what());
}

// @throws std::invalid_argument always, where checkRange() has found that
[[noreturn]] void refuseOutOfRange(std::string_view name, std::string_view value, std::string_view unit,
                                   double minimum, double maximum);

// @throws std::invalid_argument for a value that is NaN or not from `minimum` to `maximum`
template <typename Number>
void checkRange(std::string_view name, Number value, std::string_view unit, double minimum, double maximum) {
    // No text is made unless there is something to say: sources check at every step.
    if (value >= minimum && value <= maximum) return;
    refuseOutOfRange(name, textOf(value), unit, minimum, maximum);
}

// @throws std::invalid_argument for a position with a coordinate that is NaN or further than 1e9 m away
void checkPosition(std::string_view name, const Eigen::Vector3d& position);

// @throws std::invalid_argument for a step that is NaN, negative or longer than 30 years
void checkStep(double dt);

}  // namespace drench
