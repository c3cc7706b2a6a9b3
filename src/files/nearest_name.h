// Suggests a valid name for a misspelt one.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drench::files {

// The name with the smallest edit distance (insertions, deletions, replacements) to a word; none if that
// distance exceeds a third of the word's letters, rounded up. Not case-sensitive.
std::optional<std::string> nearestName(std::string_view word, const std::vector<std::string>& names);

}  // namespace drench::files
