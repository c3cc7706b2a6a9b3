// Rows of numbers under named columns, for people and for files.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace drench::demo {

/// A column: its name and how many digits after the point people see.
struct Column {
    std::string name;
    int digits;
};

/// Numbers by row; NaN means "not measured".
struct Table {
    std::vector<Column> columns;
    std::vector<std::vector<double>> rows;
};

/// Writes aligned columns; what was not measured is a dash.
void print(std::ostream& out, const Table& table);

/// Makes sure that a file can be written under a name, before the work that it is for: creates the folders
/// above it. What stands there already stays as it is.
/// @throws std::runtime_error that names the path and says what is in the way
void checkWritable(const std::filesystem::path& path);

/// Writes a file, which appears under its name only once it is whole.
/// @throws std::runtime_error as `checkWritable`, and when the disk is full
void writeWhole(const std::filesystem::path& path, const std::string& contents);

/// Writes a CSV file with a header line and full digits; what was not measured is empty. Otherwise as
/// `writeWhole`.
void writeCsv(const std::filesystem::path& path, const Table& table);

}  // namespace drench::demo
