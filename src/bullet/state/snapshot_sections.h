// The sections of a snapshot: for each a name of four letters, the size in 8 bytes, and its bytes.
#pragma once

#include <stdexcept>
#include <string_view>

#include "checks/checks.h"
#include "drench/state.h"

namespace drench {

inline constexpr std::string_view sourcesSection = "SRCS";

inline void writeSection(StateWriter& to, std::string_view name, const StateWriter& section) {
    to.writeBytes(name);
    to.write(std::string_view(section.bytes()));
}

inline StateReader readSection(StateReader& from, std::string_view name) {
    if (from.readBytes(name.size()) != name)
        refuse<std::runtime_error>("the snapshot has no section ", name, " where it belongs");
    return StateReader(from.readBytes(from.readCount(1)));
}

inline void checkEnd(const StateReader& section, std::string_view name) {
    if (section.left() > 0)
        refuse<std::runtime_error>("the section ", name, " of the snapshot has ", section.left(),
                                   " bytes too many");
}

}  // namespace drench
