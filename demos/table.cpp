#include "table.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace drench::demo {

namespace {

std::string cell(double value, int digits) {
    if (std::isnan(value)) return "-";
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << value;
    return text.str();
}

/// The name under which a file is written until it is whole.
std::filesystem::path unfinished(std::filesystem::path path) {
    path += ".part";
    return path;
}

}  // namespace

void checkWritable(const std::filesystem::path& path) {
    namespace fs = std::filesystem;
    const auto refuse = [&](const std::string& why) {
        throw std::runtime_error("cannot write " + path.string() + ": " + why);
    };
    std::error_code problem;
    if (fs::exists(path, problem) && !fs::is_regular_file(path, problem))
        refuse("it is there and is no file");
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), problem);
    if (problem) refuse("its folder cannot be created; choose another");
    std::ofstream trial(unfinished(path));
    if (!trial) refuse("its folder lets nobody write, or not you; choose another");
    trial.close();
    fs::remove(unfinished(path), problem);
}

void print(std::ostream& out, const Table& table) {
    std::vector<std::size_t> widths;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        std::size_t width = table.columns[c].name.size();
        for (const auto& row : table.rows)
            width = std::max(width, cell(row[c], table.columns[c].digits).size());
        widths.push_back(width);
    }
    const auto line = [&](const auto& textOf) {
        for (std::size_t c = 0; c < widths.size(); ++c)
            out << (c > 0 ? "  " : "") << std::setw(static_cast<int>(widths[c])) << textOf(c);
        out << '\n';
    };
    line([&](std::size_t c) { return table.columns[c].name; });
    for (const auto& row : table.rows)
        line([&](std::size_t c) { return cell(row[c], table.columns[c].digits); });
}

void writeWhole(const std::filesystem::path& path, const std::string& contents) {
    checkWritable(path);
    std::ofstream file(unfinished(path), std::ios::binary);
    file << contents;
    file.close();
    std::error_code problem;
    if (file) std::filesystem::rename(unfinished(path), path, problem);
    if (file && !problem) return;
    std::filesystem::remove(unfinished(path), problem);
    throw std::runtime_error("cannot write all of " + path.string() + "; is the disk full?");
}

void writeCsv(const std::filesystem::path& path, const Table& table) {
    std::ostringstream text;
    for (std::size_t c = 0; c < table.columns.size(); ++c)
        text << (c > 0 ? "," : "") << table.columns[c].name;
    text << '\n' << std::setprecision(9);
    for (const auto& row : table.rows) {
        for (std::size_t c = 0; c < row.size(); ++c) {
            if (c > 0) text << ',';
            if (!std::isnan(row[c])) text << row[c];
        }
        text << '\n';
    }
    writeWhole(path, text.str());
}

}  // namespace drench::demo
