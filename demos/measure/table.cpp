#include "measure/table.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "state/whole_file.h"

namespace drench::demo {

namespace {

std::string cell(double value, int digits) {
    if (std::isnan(value)) return "-";
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << value;
    return text.str();
}

}  // namespace

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
    files::writeWhole(path, text.str());
}

}  // namespace drench::demo
