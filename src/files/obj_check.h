// Checks OBJ text by line: what tinyobjloader would take for 0 or pass over.
#pragma once

#include <string>
#include <string_view>

#include "drench/files/mesh_file.h"

namespace drench::files {

// @throws std::invalid_argument that names the line, as `meshFromText`
void checkObj(std::string_view text, const MeshReadOptions& reading);

// The text without what follows a # that begins a line or stands after a blank; tinyobjloader takes comments behind
// faces for corners. Lines stay as many.
std::string withoutComments(std::string_view text);

}  // namespace drench::files
