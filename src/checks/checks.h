// Range checks of settings, with messages that name the setting, its value and the valid range.
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>
#include <string_view>

#include "checks/text.h"

namespace drench {

// Prefix of the messages of all exceptions that Drench throws itself.
inline constexpr std::string_view messagePrefix = "drench: ";

// @throws Error with the prefix and a message of these parts
template <typename Error = std::invalid_argument, typename... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
    throw Error(textOf(messagePrefix, parts...));
}

// A message without its "drench: " prefix.
std::string withoutPrefix(std::string_view message);
inline std::string reasonOf(const std::exception& problem) {
    return withoutPrefix(problem.what());
}

// @throws std::invalid_argument always; called when checkRange() has found a value out of range
[[noreturn]] void refuseOutOfRange(std::string_view name, std::string_view value, std::string_view unit,
                                   double minimum, double maximum);

// @throws std::invalid_argument for a value that is NaN or not from `minimum` to `maximum`
template <typename Number>
void checkRange(std::string_view name, Number value, std::string_view unit, double minimum, double maximum) {
    // The message is built only when needed, because sources check in every step.
    if (value >= minimum && value <= maximum) return;
    refuseOutOfRange(name, textOf(value), unit, minimum, maximum);
}

// @throws std::invalid_argument for a position with a coordinate that is NaN or beyond +-1e9 m
void checkPosition(std::string_view name, const Eigen::Vector3d& position);

// @throws std::invalid_argument for a step that is NaN, negative or longer than 30 years
void checkStep(double dt);

}  // namespace drench
