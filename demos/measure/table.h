// Rows of numbers under named columns, for people and for files.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace drench::demo {

// A column: its name and how many digits after the point people see.
struct Column {
    std::string name;
    int digits;
};

// Numbers by row; NaN means "not measured".
struct Table {
    std::vector<Column> columns;
    std::vector<std::vector<double>> rows;
};

// Writes aligned columns; what was not measured is a dash.
void print(std::ostream& out, const Table& table);

// Writes a CSV file with a header line and full digits; what was not measured is empty. Otherwise as
// `files::writeWhole`.
void writeCsv(const std::filesystem::path& path, const Table& table);

}  // namespace drench::demo
