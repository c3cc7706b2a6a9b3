// Tables of numbers with named columns, as text and CSV.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace drench::demo {

// A column: its name, and the number of decimals in text.
struct Column {
    std::string name;
    int digits;
};

// Rows of numbers; NaN means "not measured".
struct Table {
    std::vector<Column> columns;
    std::vector<std::vector<double>> rows;
};

// Writes aligned columns; values that were not measured are dashes.
void print(std::ostream& out, const Table& table);

// Writes a CSV file with a header line and full precision; values that were not measured are empty. Otherwise
// as `files::writeWhole`.
void writeCsv(const std::filesystem::path& path, const Table& table);

}  // namespace drench::demo
