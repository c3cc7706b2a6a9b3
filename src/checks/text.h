// Formats values in messages: as short as possible, but unambiguous.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>

namespace drench {

// A computed value, printed with six digits. Values from the user are printed in full.
struct SixDigits {
    double value;
};
inline SixDigits sixDigits(double value) {
    return {value};
}
template <typename Vector>
auto sixDigits(const Vector& v) -> decltype(v.z(), std::array<SixDigits, 3>()) {
    return {{{double(v.x())}, {double(v.y())}, {double(v.z())}}};
}

// A name in quotes, with '?' for control characters, cut after 60 bytes.
std::string inQuotes(std::string_view name);

namespace texts {

void append(std::string& text, double value);
void append(std::string& text, float value);  // 0.1f is 0.1
void append(std::string& text, long double value) = delete;
void append(std::string& text, SixDigits value);
void append(std::string& text, long long value);
void append(std::string& text, unsigned long long value);
void append(std::string& text, bool value);
void append(std::string& text, char letter);
void append(std::string& text, std::string_view words);
inline void append(std::string& text, const char* words) {
    append(text, std::string_view(words));
}
inline void append(std::string& text, const std::string& words) {
    append(text, std::string_view(words));
}

template <typename Integer>
std::enable_if_t<std::is_integral_v<Integer>> append(std::string& text, Integer value) {
    using Long = std::conditional_t<std::is_signed_v<Integer>, long long, unsigned long long>;
    append(text, static_cast<Long>(value));
}

template <typename First, typename... Rest>
void appendList(std::string& text, const First& first, const Rest&... rest) {
    append(text, '(');
    append(text, first);
    ((append(text, ", "), append(text, rest)), ...);
    append(text, ')');
}

// Three components, as in vectors of Eigen and of Bullet.
template <typename Vector>
auto append(std::string& text, const Vector& v) -> decltype(v.x(), v.y(), void(v.z())) {
    appendList(text, v.x(), v.y(), v.z());
}

template <typename Number>
void append(std::string& text, const std::array<Number, 3>& v) {
    appendList(text, v[0], v[1], v[2]);
}

}  // namespace texts

// Concatenates the parts of a message: text unchanged, numbers in the shortest form that reads back the same,
// vectors as (x, y, z).
template <typename... Parts>
std::string textOf(const Parts&... parts) {
    std::string text;
    (texts::append(text, parts), ...);
    return text;
}

}  // namespace drench
