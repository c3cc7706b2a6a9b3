#include "checks/checks.h"

namespace drench {

std::string withoutPrefix(std::string_view message) {
    if (message.substr(0, messagePrefix.size()) == messagePrefix) message.remove_prefix(messagePrefix.size());
    return std::string(message);
}

void refuseOutOfRange(std::string_view name, std::string_view value, std::string_view unit, double minimum,
                      double maximum) {
    refuse(name, " is ", value, unit.empty() ? "" : " ", unit, "; give a value from ", minimum, " to ",
           maximum);
}

void checkPosition(std::string_view name, const Eigen::Vector3d& position) {
    if (position.allFinite() && position.cwiseAbs().maxCoeff() <= 1e9) return;
    refuse(name, " is ", position, " m; give three finite numbers from -1e9 to 1e9");
}

void checkStep(double dt) {
    checkRange("the time step of a source", dt, "s", 0, 1e9);
}

}  // namespace drench
