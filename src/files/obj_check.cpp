#include "files/obj_check.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

#include "checks/text.h"

namespace drench::files {

namespace {

constexpr long maxVertices = 1'000'000;

// The words of a line, one after the other.
class Words {
  public:
    explicit Words(std::string_view line) : rest_(line) {}

    // Empty at the end of the line, and at a comment.
    std::string_view next() {
        constexpr const char* blanks = " \t";
        const std::size_t from = rest_.find_first_not_of(blanks);
        if (from == std::string_view::npos || rest_[from] == '#') return rest_ = {};
        rest_.remove_prefix(from);
        const std::string_view word = rest_.substr(0, rest_.find_first_of(blanks));
        rest_.remove_prefix(word.size());
        return word;
    }

  private:
    std::string_view rest_;
};

std::string quotedWord(std::string_view word) {
    constexpr std::size_t longest = 30;
    std::string text;
    for (const char c : word.substr(0, longest)) text += c > ' ' && c < 127 ? c : '?';
    return '\'' + text + (word.size() > longest ? "...'" : "'");
}

template <typename Number>
bool isRead(std::string_view word, Number& number) {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), number);
    return problem == std::errc() && end == word.data() + word.size();
}

class Check {
  public:
    explicit Check(const MeshReadOptions& reading) : reading_(reading) {}

    void line(std::string_view text) {
        ++line_;
        Words words(text);
        const std::string_view kind = words.next();
        if (kind == "v") {
            numbers(words, "a vertex", 3, reading_.scale);
            if (++vertices_ > maxVertices)
                refuse("there are more than a million vertices; give a coarser mesh");
        } else if (kind == "vt") {
            numbers(words, "a texture coordinate", reading_.texture ? 2 : 1, 1);
            ++textures_;
        } else if (kind == "f") {
            face(words);
        }
    }

    void finish() const {
        if (faces_ == 0)
            throw std::invalid_argument(
                "it has no faces (lines that begin with f); cloth needs at least one");
    }

  private:
    template <typename... Parts>
    [[noreturn]] void refuse(const Parts&... what) const {
        throw std::invalid_argument(textOf("line ", line_, ": ", what...));
    }

    void numbers(Words& words, const char* what, int wanted, double scale) const {
        constexpr double furthest = 1e6;
        for (int i = 0; i < wanted; ++i) {
            const std::string_view word = words.next();
            double number = 0;
            if (word.empty()) refuse(what, " has ", i, " numbers; give ", wanted);
            if (!isRead(word, number) || !(std::abs(number * scale) <= furthest)) {
                const SixDigits max = sixDigits(furthest / scale);
                refuse(what, " has the number ", quotedWord(word), "; give finite numbers from -", max,
                       " to ", max);
            }
        }
    }

    void face(Words& words) {
        constexpr int maxCorners = 1000;
        int corners = 0;
        for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
            if (++corners > maxCorners) refuse("a face has more than 1000 corners; cut it into smaller ones");
            corner(word);
        }
        if (corners < 3) refuse("a face has ", corners, " corners; give at least 3");
        ++faces_;
    }

    // A corner: 3, 3/1, 3/1/2 or 3//2; negative numbers count back from the last vertex.
    void corner(std::string_view word) const {
        const std::size_t slash = word.find('/');
        index(word, word.substr(0, slash), vertices_, "vertices");
        std::string_view texture = slash == std::string_view::npos ? "" : word.substr(slash + 1);
        texture = texture.substr(0, texture.find('/'));
        if (!texture.empty()) index(word, texture, textures_, "texture coordinates");
        if (texture.empty() && reading_.texture)
            refuse("the corner ", quotedWord(word),
                   " has no texture coordinate; read the file without them, or give each corner one");
    }

    void index(std::string_view corner, std::string_view word, long count, const char* of) const {
        long number = 0;
        if (isRead(word, number) && number != 0 && number <= count && number >= -count) return;
        refuse("a face has the corner ", quotedWord(corner), "; there are ", count, ' ', of,
               " before it, counted from 1, or from -1 backwards");
    }

    const MeshReadOptions& reading_;
    long line_ = 0, vertices_ = 0, textures_ = 0, faces_ = 0;
};

}  // namespace

void checkObj(std::string_view text, const MeshReadOptions& reading) {
    Check check(reading);
    while (!text.empty()) {
        const std::size_t end = text.find_first_of("\r\n");
        check.line(text.substr(0, end));
        const bool isTwo = text.substr(std::min(end, text.size()), 2) == "\r\n";
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + (isTwo ? 2 : 1));
    }
    check.finish();
}

std::string withoutComments(std::string_view text) {
    std::string kept;
    kept.reserve(text.size());
    bool inComment = false;
    for (const char c : text) {
        const bool isFree =
            kept.empty() || std::string_view(" \t\r\n").find(kept.back()) != std::string_view::npos;
        inComment = c != '\r' && c != '\n' && (inComment || (c == '#' && isFree));
        if (!inComment) kept += c;
    }
    return kept;
}

}  // namespace drench::files
