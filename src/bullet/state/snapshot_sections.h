// The sections of a snapshot's state: four letters, the size in 8 bytes, and so many bytes each.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "drench/state.h"

namespace drench {

inline constexpr std::string_view sourcesSection = "SRCS";

inline void writeSection(StateWriter& to, std::string_view name, const StateWriter& section) {
    to.writeBytes(name);
    to.write(std::string_view(section.bytes()));
}

inline StateReader readSection(StateReader& from, std::string_view name) {
    if (from.readBytes(name.size()) != name)
        throw std::runtime_error("drench: the snapshot has no section " + std::string(name) +
                                 " where it belongs");
    return StateReader(from.readBytes(from.readCount(1)));
}

inline void checkEnd(const StateReader& section, std::string_view name) {
    if (section.left() > 0)
        throw std::runtime_error("drench: the section " + std::string(name) + " of the snapshot has " +
                                 std::to_string(section.left()) + " bytes too many");
}

}  // namespace drench
