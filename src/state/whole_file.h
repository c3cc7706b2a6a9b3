// Files that are read completely, and written atomically. If a path is a symbolic link, its target is used.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace drench::files {

// Checks that a file can be written, before the work that produces it, and makes missing parent folders. An
// existing file is not changed. Throws std::runtime_error with the path and the reason.
void checkWritable(const std::filesystem::path& path);

// Writes a file atomically: under a unique temporary name in the same folder, which is then renamed. Throws
// std::runtime_error as checkWritable, and when the disk is full; the temporary file is then removed.
void writeWhole(const std::filesystem::path& path, std::string_view contents);

// Reads a file of at most `maxBytes`. Throws std::invalid_argument with the reason; the caller adds the path.
std::string readWhole(const std::filesystem::path& path, std::size_t maxBytes);

}  // namespace drench::files
