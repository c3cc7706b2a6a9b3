// What somebody most likely meant who mistyped a name.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drench::files {

// The name that takes the fewest letters put in, left out or exchanged to come to; none if that is more than a third
// of the word's letters, rounded up. Upper and lower case count as the same.
std::optional<std::string> nearestName(std::string_view word, const std::vector<std::string>& names);

}  // namespace drench::files
