#include "files/json_fields.h"

#include <algorithm>
#include <stdexcept>

#include "checks/text.h"
#include "files/nearest_name.h"

namespace drench::files {

namespace {

std::string between(const Range& range) {
    return textOf(range.min, " to ", range.max);
}

bool isWithin(const nlohmann::json& value, const Range& range) {
    if (!value.is_number()) return false;
    const double number = value.get<double>();
    return number >= range.min && number <= range.max;
}

bool mayBeInName(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' ||
           c == '-' || c == '_';
}

}  // namespace

std::string shown(const nlohmann::json& value) {
    constexpr std::size_t longest = 60;
    if (value.is_object()) return "an object";
    if (value.is_array()) return textOf("a list of ", value.size());
    std::string text = value.dump(-1, ' ', true);
    if (text.size() > longest) text = text.substr(0, longest) + "...";
    return text;
}

FieldReader::FieldReader(const nlohmann::json& object, std::string path)
    : object_(object), path_(std::move(path)) {
    if (!object_.is_object())
        throw std::invalid_argument((path_.empty() ? "the file" : path_) + " is " + shown(object_) +
                                    "; give an object, {...}");
}

std::string FieldReader::pathOf(const std::string& key) const {
    return path_.empty() ? key : path_ + '.' + key;
}

const nlohmann::json* FieldReader::any(const std::string& key) {
    known_.insert(key);
    const auto found = object_.find(key);
    return found == object_.end() ? nullptr : &*found;
}

double FieldReader::numberAt(const nlohmann::json& list, std::size_t index, const std::string& key,
                             const Range& range) const {
    const nlohmann::json& value = list[index];
    if (isWithin(value, range)) return value.get<double>();
    refuse(textOf(key, '[', index, ']'), "is ", shown(value), "; give a number, ", between(range));
}

void FieldReader::checkList(const std::string& key, const nlohmann::json& value, const char* of) const {
    if (!value.is_array()) refuse(key, "is ", shown(value), "; give a list of ", of);
}

void FieldReader::number(const std::string& key, double& value, const Range& range) {
    const nlohmann::json* found = any(key);
    if (!found) return;
    if (!isWithin(*found, range)) refuse(key, "is ", shown(*found), "; give a number, ", between(range));
    value = found->get<double>();
}

void FieldReader::integer(const std::string& key, int& value, int min, int max) {
    const nlohmann::json* found = any(key);
    if (!found) return;
    const double number = found->is_number() ? found->get<double>() : min - 1.0;
    if (!(number >= min && number <= max) || number != std::floor(number))
        refuse(key, "is ", shown(*found), "; give a whole number, ", min, " to ", max);
    value = static_cast<int>(number);
}

void FieldReader::boolean(const std::string& key, bool& value) {
    const nlohmann::json* found = any(key);
    if (!found) return;
    if (!found->is_boolean()) refuse(key, "is ", shown(*found), "; give true or false");
    value = found->get<bool>();
}

void FieldReader::string(const std::string& key, std::string& value) {
    constexpr std::size_t longest = 1000;
    const nlohmann::json* found = any(key);
    if (!found) return;
    if (!found->is_string()) refuse(key, "is ", shown(*found), "; give a text in quotes");
    if (found->get_ref<const std::string&>().size() > longest)
        refuse(key, "is too long; give at most ", longest, " bytes");
    value = found->get<std::string>();
}

void FieldReader::name(const std::string& key, std::string& value) {
    constexpr std::size_t longest = 64;
    const nlohmann::json* found = any(key);
    if (!found) return;
    const std::string wanted = found->is_string() ? found->get<std::string>() : "";
    if (wanted.empty() || wanted.size() > longest || !std::all_of(wanted.begin(), wanted.end(), mayBeInName))
        refuse(key, "is ", shown(*found), "; give 1 to ", longest, " letters, digits, blanks, - or _");
    value = wanted;
}

void FieldReader::numbers(const std::string& key, std::vector<double>& values, const Range& range) {
    const nlohmann::json* found = any(key);
    if (!found) return;
    values.clear();
    checkList(key, *found, "numbers");
    for (std::size_t i = 0; i < found->size(); ++i) values.push_back(numberAt(*found, i, key, range));
}

void FieldReader::vectors(const std::string& key, std::vector<Eigen::Vector3d>& values, const Range& range) {
    std::vector<double> flat;
    numbers(key, flat, range);
    if (flat.size() % 3 != 0) refuse(key, "is a list of ", flat.size(), "; give three numbers for each node");
    for (std::size_t i = 0; i < flat.size(); i += 3) values.emplace_back(flat[i], flat[i + 1], flat[i + 2]);
}

void FieldReader::finish() const {
    for (const auto& [key, value] : object_.items())
        if (known_.count(key) == 0) refuseUnknown(key);
}

void FieldReader::refuseUnknown(const std::string& key) const {
    const std::vector<std::string> names(known_.begin(), known_.end());
    std::string known;
    for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
    const auto nearest = nearestName(key, names);
    refuse(shownKey(key), "is no key of this object; ",
           nearest ? "did you mean " + *nearest + "? There are " : "there are ", known);
}

void FieldWriter::vectors(const std::string& key, const std::vector<Eigen::Vector3d>& values, const Range&) {
    std::vector<double> flat;
    for (const Eigen::Vector3d& value : values) flat.insert(flat.end(), value.data(), value.data() + 3);
    object_[key] = flat;
}

}  // namespace drench::files
