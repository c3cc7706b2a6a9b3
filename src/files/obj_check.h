// Checks OBJ text line by line for errors that tinyobjloader would ignore or read as 0.
#pragma once

#include <string>
#include <string_view>

#include "drench/files/mesh_file.h"

namespace drench::files {

// @throws std::invalid_argument that names the line, as `meshFromText`
void checkObj(std::string_view text, const MeshReadOptions& reading);

// The text without comments that start at # at the start of a line or after a space, because tinyobjloader
// reads comments after faces as corners. The number of lines is not changed.
std::string withoutComments(std::string_view text);

}  // namespace drench::files
