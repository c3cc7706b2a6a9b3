#include "files/nearest_name.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace drench::files {

namespace {

bool isSameLetter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

// Levenshtein distance, row by row.
std::size_t distance(std::string_view from, std::string_view to) {
    std::vector<std::size_t> row(to.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t(0));
    for (std::size_t i = 0; i < from.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < to.size(); ++j) {
            const std::size_t exchanged = diagonal + (isSameLetter(from[i], to[j]) ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({exchanged, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::optional<std::string> nearestName(std::string_view word, const std::vector<std::string>& names) {
    constexpr std::size_t longest = 100;  // of names that are compared
    if (word.size() > longest) return std::nullopt;
    std::size_t nearest = (word.size() + 2) / 3;
    std::optional<std::string> found;
    for (const std::string& name : names) {
        const std::size_t far = distance(word, name);
        if (far > nearest || (found && far == nearest)) continue;
        nearest = far;
        found = name;
    }
    return found;
}

}  // namespace drench::files
