#include "drench/files/cloth_frame.h"

#include <algorithm>
#include <cmath>

#include "checks/checks.h"

namespace drench {

namespace {

template <typename... Parts>
[[noreturn]] void refuseFrame(const ClothFrame& frame, const Parts&... parts) {
    refuse("sheet ", inQuotes(frame.name), ": ", parts...);
}

bool isFinite(double value) {
    return std::isfinite(value);
}
bool isFinite(const Eigen::Vector3f& value) {
    return value.allFinite();
}

template <typename Value>
void checkList(const ClothFrame& frame, const char* name, const std::vector<Value>& values) {
    if (values.size() != frame.positions.size())
        refuseFrame(frame, "there are ", frame.positions.size(), " positions and ", values.size(), ' ', name,
                    "; give one of each for a node");
    for (std::size_t node = 0; node < values.size(); ++node)
        if (!isFinite(values[node]))
            refuseFrame(frame, name, " of node ", node,
                        " are not finite; the run has gone wrong before this frame");
}

void checkName(const ClothFrame& frame) {
    constexpr std::size_t longest = 64;
    const bool isPlain = std::all_of(frame.name.begin(), frame.name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' ||
               c == '-' || c == '_';
    });
    if (frame.name.empty() || frame.name.size() > longest || !isPlain)
        refuseFrame(frame, "give it a name of 1 to 64 letters, digits, blanks, - or _");
}

bool isMesh(const ClothFrame& frame) {
    const auto isThere = [&](int node) {
        return node >= 0 && static_cast<std::size_t>(node) < frame.positions.size();
    };
    return !frame.triangles.empty() &&
           std::all_of(frame.triangles.begin(), frame.triangles.end(), [&](const auto& triangle) {
               return std::all_of(triangle.begin(), triangle.end(), isThere);
           });
}

}  // namespace

void validate(const ClothFrame& frame) {
    checkName(frame);
    if (!isMesh(frame)) refuseFrame(frame, "it has no triangles, or one with a node that is not there");
    checkList(frame, "positions", frame.positions);
    checkList(frame, "normals", frame.normals);
    checkList(frame, "masses", frame.masses);
    checkList(frame, "poreMasses", frame.poreMasses);
    checkList(frame, "filmMasses", frame.filmMasses);
    checkList(frame, "filmThicknesses", frame.filmThicknesses);
    checkList(frame, "moistureContents", frame.moistureContents);
    checkList(frame, "saturations", frame.saturations);
    checkList(frame, "glosses", frame.glosses);
    checkList(frame, "colours", frame.colours);
}

}  // namespace drench
