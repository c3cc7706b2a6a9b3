// JSON as text, read with care and written for people.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace drench::files {

// Bounds on a text, so that none can exhaust the machine.
struct JsonLimits {
    std::size_t bytes = 64u << 20;    // of the text
    int depth = 16;                   // of lists and objects in each other
    std::size_t values = 20'000'000;  // in all, lists and objects among them
};

// Reads UTF-8 text in which no object has a key twice.
// @throws std::invalid_argument that names line and column of broken syntax, or the key by its path
nlohmann::json parseJson(std::string_view text, const JsonLimits& limits = {});

// A key as messages name it: short, and without what could disturb a terminal.
std::string shownKey(const std::string& key);

// Text with a line for each key; lists of plain values stay on one line.
std::string prettyText(const nlohmann::ordered_json& value);

}  // namespace drench::files
