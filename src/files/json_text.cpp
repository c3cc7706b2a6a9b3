#include "files/json_text.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <vector>

#include "checks/text.h"

namespace drench::files {

namespace {

using nlohmann::json;

// Checks a text value by value while it is parsed.
class Watch {
  public:
    explicit Watch(const JsonLimits& limits) : limits_(limits) {}

    void see(json::parse_event_t event, const json& value) {
        using Event = json::parse_event_t;
        switch (event) {
            case Event::key:
                enter(value.get_ref<const std::string&>());
                break;
            case Event::object_start:
            case Event::array_start:
                count();
                if (int(levels_.size()) >= limits_.depth)
                    throw std::invalid_argument(textOf(path(), ": lists and objects are more than ",
                                                       limits_.depth, " deep in each other"));
                levels_.push_back({event == Event::array_start, 0, {}, {}});
                break;
            case Event::object_end:
            case Event::array_end:
                levels_.pop_back();
                break;
            case Event::value:
                count();
                break;
        }
    }

  private:
    struct Level {
        bool isList;
        std::size_t index;  // index of the next entry
        std::string key;    // key of the next value
        std::set<std::string> keys;
    };

    void enter(const std::string& key) {
        levels_.back().key = key;
        if (!levels_.back().keys.insert(key).second)
            throw std::invalid_argument(path() + " is there twice; leave one out");
    }

    void count() {
        if (++values_ > limits_.values)
            throw std::invalid_argument(textOf("there are more than ", limits_.values, " values in it"));
        if (!levels_.empty() && levels_.back().isList) ++levels_.back().index;
    }

    std::string path() const {
        std::string text;
        for (const Level& level : levels_)
            text += level.isList ? textOf('[', level.index - 1, ']')
                                 : (text.empty() ? "" : ".") + shownKey(level.key);
        return text.empty() ? "the file" : text;
    }

    const JsonLimits& limits_;
    std::vector<Level> levels_;
    std::size_t values_ = 0;
};

std::string shortened(const std::string& text) {
    constexpr std::size_t longest = 200;
    return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

// The message of a parser, without its name and its position prefix.
std::string reason(const std::string& message) {
    std::size_t from = message.find("] ");
    from = from == std::string::npos ? 0 : from + 2;
    const std::size_t position = message.find("parse error at", from);
    if (position != std::string::npos) {
        const std::size_t end = message.find(": ", position);
        if (end != std::string::npos) from = end + 2;
    }
    return shortened(message.substr(from));
}

[[noreturn]] void refuseSyntax(std::string_view text, const json::parse_error& problem) {
    const std::size_t at = std::min(text.size(), problem.byte > 0 ? problem.byte - 1 : 0);
    const std::string_view before = text.substr(0, at);
    const std::size_t line = 1 + std::size_t(std::count(before.begin(), before.end(), '\n'));
    const std::size_t lineStart = before.rfind('\n');
    const std::size_t column = at - (lineStart == std::string_view::npos ? 0 : lineStart + 1) + 1;
    throw std::invalid_argument(textOf("line ", line, ", column ", column, ": ", reason(problem.what())));
}

void write(const nlohmann::ordered_json& value, std::string& text, std::size_t indent) {
    const bool isPlainList =
        value.is_array() && std::none_of(value.begin(), value.end(), [](const auto& entry) {
            return entry.is_object() || (entry.is_array() && entry.size() > 2);
        });
    if (value.empty() || isPlainList || !value.is_structured()) {
        text += value.dump();
        return;
    }
    const std::string margin(indent + 2, ' ');
    text += value.is_array() ? "[\n" : "{\n";
    bool first = true;
    for (const auto& [key, entry] : value.items()) {
        text += (first ? "" : ",\n") + margin;
        first = false;
        if (value.is_object()) text += nlohmann::ordered_json(key).dump() + ": ";
        write(entry, text, indent + 2);
    }
    text += '\n' + std::string(indent, ' ') + (value.is_array() ? ']' : '}');
}

}  // namespace

json parseJson(std::string_view text, const JsonLimits& limits) {
    if (text.size() > limits.bytes)
        throw std::invalid_argument(textOf("it has more than ", limits.bytes >> 20, " MB"));
    Watch watch(limits);
    try {
        return json::parse(text, [&watch](int, json::parse_event_t event, json& value) {
            watch.see(event, value);
            return true;
        });
    } catch (const json::parse_error& problem) {
        refuseSyntax(text, problem);
    } catch (const json::exception& problem) {
        throw std::invalid_argument(reason(problem.what()));
    }
}

std::string shownKey(const std::string& key) {
    constexpr std::size_t longest = 40;
    const bool isPlain = key.size() <= longest && std::all_of(key.begin(), key.end(), [](char c) {
                             return c > ' ' && c < 127 && c != '.' && c != '"';
                         });
    if (isPlain && !key.empty()) return key;
    const std::string quoted = json(key).dump(-1, ' ', true);
    return quoted.size() <= longest ? quoted : quoted.substr(0, longest) + "...";
}

std::string prettyText(const nlohmann::ordered_json& value) {
    std::string text;
    write(value, text, 0);
    return text + '\n';
}

}  // namespace drench::files
