#include "checks/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace drench {

namespace {

// Simplifies the exponent that std::to_chars writes: 1e-07 becomes 1e-7, and 1e+300 becomes 1e300.
void appendTidy(std::string& text, std::string_view number) {
    const std::size_t e = number.find('e');
    text += number.substr(0, e);
    if (e == std::string_view::npos) return;
    text += 'e';
    std::string_view exponent = number.substr(e + 1);
    if (exponent.front() == '-') text += '-';
    exponent.remove_prefix(exponent.find_first_of("123456789"));
    text += exponent;
}

template <typename Number, typename... Format>
void appendNumber(std::string& text, Number value, Format... format) {
    char digits[64];
    const auto written = std::to_chars(std::begin(digits), std::end(digits), value, format...);
    appendTidy(text, std::string_view(digits, static_cast<std::size_t>(written.ptr - digits)));
}

template <typename Float>
void appendFloat(std::string& text, Float value) {
    if (std::isnan(value))
        text += "NaN";
    else if (std::isinf(value))
        text += value < 0 ? "-infinity" : "infinity";
    else if (std::abs(value) >= Float(1e-4) && std::abs(value) < Float(1e6))
        appendNumber(text, value, std::chars_format::fixed);  // 100000 is easier to read than 1e5
    else
        appendNumber(text, value);
}

}  // namespace

std::string inQuotes(std::string_view name) {
    constexpr std::size_t longest = 60;
    std::size_t end = std::min(name.size(), longest);
    if (name.size() > longest)
        while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0u) == 0x80u)
            --end;  // within a UTF-8 character
    std::string text = "'";
    for (const char c : name.substr(0, end))
        text += static_cast<unsigned char>(c) < ' ' || c == 127 ? '?' : c;
    return text + (name.size() > longest ? "...'" : "'");
}

namespace texts {

void append(std::string& text, double value) {
    appendFloat(text, value);
}

void append(std::string& text, float value) {
    appendFloat(text, value);
}

void append(std::string& text, SixDigits rounded) {
    if (std::isfinite(rounded.value))
        appendNumber(text, rounded.value, std::chars_format::general, 6);
    else
        append(text, rounded.value);
}

void append(std::string& text, long long value) {
    appendNumber(text, value);
}

void append(std::string& text, unsigned long long value) {
    appendNumber(text, value);
}

void append(std::string& text, bool value) {
    text += value ? "true" : "false";
}

void append(std::string& text, char letter) {
    text += letter;
}

void append(std::string& text, std::string_view words) {
    text += words;
}

}  // namespace texts

}  // namespace drench
