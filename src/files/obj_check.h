// Checks OBJ text by line: what tinyobjloader would take for 0 or pass over.
#pragma once

#include <string_view>

#include "drench/files/mesh_file.h"

namespace drench::files {

/// @throws std::invalid_argument that names the line, as `meshFromText`
void checkObj(std::string_view text, const MeshReading& reading);

}  // namespace drench::files
