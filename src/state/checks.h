// Checks of settings, with messages that name the setting and say how to mend it.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace drench {

/// @throws std::invalid_argument for a value that is no number or not from `minimum` to `maximum`
inline void checkRange(std::string_view name, double value, std::string_view unit, double minimum,
                       double maximum) {
    // No text is made unless there is something to say: sources check at every step.
    if (value >= minimum && value <= maximum) return;
    std::ostringstream message;
    message << "drench: " << name << " is " << value << (unit.empty() ? "" : " ") << unit
            << "; give a value from " << minimum << " to " << maximum;
    throw std::invalid_argument(message.str());
}

/// @throws std::invalid_argument for a place with a coordinate that is no number or further than 1e9 m away
inline void checkPlace(std::string_view name, const Eigen::Vector3d& place) {
    if (place.allFinite() && place.cwiseAbs().maxCoeff() <= 1e9) return;
    std::ostringstream message;
    message << "drench: " << name << " is (" << place.transpose()
            << ") m; give three finite numbers, none beyond 1e9";
    throw std::invalid_argument(message.str());
}

/// @throws std::invalid_argument for a step that is no number, negative or longer than 30 years
inline void checkStep(double dt) {
    checkRange("the time step of a source", dt, "s", 0, 1e9);
}

}  // namespace drench
