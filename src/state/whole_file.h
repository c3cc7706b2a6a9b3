// Files that are read whole, and appear under their names only once they are whole. A name that is a link stands for
// where it points.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace drench::files {

// Makes sure that a file can be written under a name, before the work that it is for: creates the folders above it.
// What stands there already stays as it is. Throws std::runtime_error that names the path and says what is in the way.
void checkWritable(const std::filesystem::path& path);

// Writes a file. Until it is whole it has another name, which nothing else has, beside the final one. Throws
// std::runtime_error as checkWritable, and when the disk is full; nothing unfinished is then left.
void writeWhole(const std::filesystem::path& path, std::string_view contents);

// Reads all of a file of at most so many bytes. Throws std::invalid_argument that says what is wrong with it, and
// leaves it to the caller to say with which.
std::string readWhole(const std::filesystem::path& path, std::size_t maxBytes);

}  // namespace drench::files
