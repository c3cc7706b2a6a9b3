// JSON text: parsed with limits, written in a readable layout.
#pragma once

#include <string>
#include <string_view>

#include "files/json.h"

namespace drench::files {

// Limits of a text, so that memory and stack suffice.
struct JsonLimits {
    std::size_t bytes = 64u << 20;    // size of the text
    int depth = 16;                   // nesting of lists and objects
    std::size_t values = 20'000'000;  // total number, including lists and objects
};

// Parses UTF-8 text, and refuses duplicate keys.
// @throws std::invalid_argument with line and column of a syntax error, or the path of the key
nlohmann::json parseJson(std::string_view text, const JsonLimits& limits = {});

// A key for messages: shortened, and without control characters.
std::string shownKey(const std::string& key);

// Text with one line per key; lists of plain values are on one line.
std::string prettyText(const nlohmann::ordered_json& value);

}  // namespace drench::files
