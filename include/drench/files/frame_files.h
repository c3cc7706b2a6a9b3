// Single moments of sheets, as OBJ meshes and tables in CSV. Sequences are numbered files.
#pragma once

#include <filesystem>
#include <vector>

#include "drench/export.h"
#include "drench/files/cloth_frame.h"

namespace drench {

/// Writes sheets as one OBJ file: an object each, vertices (v, m), normals (vn) and triangles (f). Numbers have 9
/// digits, so that single precision comes back as it was. The file appears under its name only once it is whole.
/// @throws std::invalid_argument for frames that `validate` refuses, or none; std::runtime_error that names the path
///     and says what is in the way
DRENCH_API void writeObj(const std::filesystem::path& path, const std::vector<ClothFrame>& sheets);

/// Writes sheets as one CSV file (RFC 4180, but lines end with a line feed), a line for each node:
/// `time_s, sheet, node, x_m, y_m, z_m, mass_kg, pore_kg, film_kg, film_m, content_kg_per_kg, saturation, red, green,
/// blue`; film_m is the thickness on one face, the colour is linear. Otherwise as `writeObj`.
/// @param time  that the lines begin with, s
/// @throws also std::invalid_argument for a time that is not finite
DRENCH_API void writeCsv(const std::filesystem::path& path, double time,
                         const std::vector<ClothFrame>& sheets);

/// The name of one file of a sequence: `run/cloth.obj` becomes `run/cloth.0012.obj`. Four digits, or more where they are
/// needed.
/// @throws std::invalid_argument for a number below 0
DRENCH_API std::filesystem::path numbered(const std::filesystem::path& path, int number);

}  // namespace drench
