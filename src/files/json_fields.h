// Fields of a JSON object; the same code reads and writes them.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "checks/text.h"
#include "files/json.h"
#include "files/json_text.h"

namespace drench::files {

// Smallest and largest value of a number.
struct Range {
    double min, max;
};

// Names for the values of an enumeration.
template <typename Value>
using Names = std::vector<std::pair<std::string, Value>>;

// Reads an object, key by key. If a key is absent, the value is not changed. Every call throws
// std::invalid_argument with the path of the key, the problem and the valid values.
class FieldReader {
  public:
    static constexpr bool reads = true;

    // @param path  of the object; empty for the whole file
    FieldReader(const nlohmann::json& object, std::string path);

    void number(const std::string& key, double& value, const Range& range);
    void integer(const std::string& key, int& value, int min, int max);
    void boolean(const std::string& key, bool& value);
    void string(const std::string& key, std::string& value);
    // A name of letters, digits, spaces, - and _, so that it can be part of a file name or a column name.
    void name(const std::string& key, std::string& value);
    // A list of `Size` numbers; the vector must be at least `minLength` long.
    template <int Size>
    void vector(const std::string& key, Eigen::Matrix<double, Size, 1>& value, const Range& range,
                double minLength = 0);
    void numbers(const std::string& key, std::vector<double>& values, const Range& range);
    void vectors(const std::string& key, std::vector<Eigen::Vector3d>& values, const Range& range);
    template <typename Value>
    void choice(const std::string& key, Value& value, const Names<Value>& names);
    // Calls a function with the fields of an object, if present.
    template <typename Function>
    bool object(const std::string& key, Function function);
    // A list of at most 1000 objects; calls a function for each.
    template <typename Entry, typename Function>
    void list(const std::string& key, std::vector<Entry>& entries, Function function);

    // The value of a key, of any type; null if absent.
    const nlohmann::json* any(const std::string& key);
    std::string pathOf(const std::string& key) const;
    template <typename... Parts>
    [[noreturn]] void refuse(const std::string& key, const Parts&... why) const {
        throw std::invalid_argument(textOf(pathOf(key), ' ', why...));
    }
    // Refuses keys that have not been read.
    void finish() const;

  private:
    // The number at an index of a list.
    double numberAt(const nlohmann::json& list, std::size_t index, const std::string& key,
                    const Range& range) const;
    [[noreturn]] void refuseUnknown(const std::string& key) const;
    void checkList(const std::string& key, const nlohmann::json& value, const char* of) const;

    const nlohmann::json& object_;
    std::string path_;
    std::set<std::string> known_;
};

// Writes an object, with the same functions.
class FieldWriter {
  public:
    static constexpr bool reads = false;

    void number(const std::string& key, double value, const Range&) {
        if (std::isfinite(value)) object_[key] = value;
    }
    void integer(const std::string& key, int value, int, int) { object_[key] = value; }
    void boolean(const std::string& key, bool value) { object_[key] = value; }
    void string(const std::string& key, const std::string& value) { object_[key] = value; }
    void name(const std::string& key, const std::string& value) {
        if (!value.empty()) object_[key] = value;
    }
    template <int Size>
    void vector(const std::string& key, const Eigen::Matrix<double, Size, 1>& value, const Range&,
                double = 0) {
        object_[key] = std::vector<double>(value.data(), value.data() + Size);
    }
    void numbers(const std::string& key, const std::vector<double>& values, const Range&) {
        object_[key] = values;
    }
    void vectors(const std::string& key, const std::vector<Eigen::Vector3d>& values, const Range&);
    template <typename Value>
    void choice(const std::string& key, const Value& value, const Names<Value>& names) {
        for (const auto& [name, meaning] : names)
            if (meaning == value) object_[key] = name;
    }
    template <typename Function>
    bool object(const std::string& key, Function function) {
        FieldWriter inner;
        function(inner);
        object_[key] = std::move(inner.object_);
        return true;
    }
    template <typename Entry, typename Function>
    void list(const std::string& key, std::vector<Entry>& entries, Function function);

    void put(const std::string& key, nlohmann::ordered_json value) { object_[key] = std::move(value); }
    const nlohmann::ordered_json& result() const { return object_; }
    void finish() const {}

  private:
    nlohmann::ordered_json object_ = nlohmann::ordered_json::object();
};

// "1.5", or the type of the value.
std::string shown(const nlohmann::json& value);

template <int Size>
void FieldReader::vector(const std::string& key, Eigen::Matrix<double, Size, 1>& value, const Range& range,
                         double minLength) {
    const nlohmann::json* found = any(key);
    if (!found) return;
    if (!found->is_array() || found->size() != std::size_t(Size))
        refuse(key, "is ", shown(*found), "; give a list of ", Size, " numbers");
    for (int i = 0; i < Size; ++i) value[i] = numberAt(*found, std::size_t(i), key, range);
    if (!(value.norm() >= minLength))
        refuse(key, "is too short; give a vector at least ", minLength, " long");
}

template <typename Value>
void FieldReader::choice(const std::string& key, Value& value, const Names<Value>& names) {
    const nlohmann::json* found = any(key);
    if (!found) return;
    std::string known;
    for (const auto& [name, meaning] : names) {
        if (*found == name) {
            value = meaning;
            return;
        }
        known += (known.empty() ? "\"" : ", \"") + name + '"';
    }
    refuse(key, "is ", shown(*found), "; give one of ", known);
}

template <typename Function>
bool FieldReader::object(const std::string& key, Function function) {
    const nlohmann::json* found = any(key);
    if (!found) return false;
    FieldReader inner(*found, pathOf(key));
    function(inner);
    inner.finish();
    return true;
}

template <typename Entry, typename Function>
void FieldReader::list(const std::string& key, std::vector<Entry>& entries, Function function) {
    const nlohmann::json* found = any(key);
    if (!found) return;
    constexpr std::size_t max = 1000;
    checkList(key, *found, "objects");
    if (found->size() > max) refuse(key, "is ", shown(*found), "; give at most ", max, " objects");
    for (std::size_t i = 0; i < found->size(); ++i) {
        FieldReader inner((*found)[i], textOf(pathOf(key), '[', i, ']'));
        function(inner, entries.emplace_back());
        inner.finish();
    }
}

template <typename Entry, typename Function>
void FieldWriter::list(const std::string& key, std::vector<Entry>& entries, Function function) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (Entry& entry : entries) {
        FieldWriter inner;
        function(inner, entry);
        list.push_back(std::move(inner.object_));
    }
    object_[key] = std::move(list);
}

}  // namespace drench::files
