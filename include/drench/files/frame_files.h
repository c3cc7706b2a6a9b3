// Single frames of sheets as OBJ meshes and CSV tables. A sequence is a set of numbered files.
#pragma once

#include <filesystem>
#include <vector>

#include "drench/config.h"
#include "drench/files/cloth_frame.h"

namespace drench {

/// Writes sheets as one OBJ file, atomically: one object per sheet, with vertices (v, m), normals (vn) and triangles
/// (f). Numbers have 9 digits, which represent single precision exactly.
/// @throws std::invalid_argument for no frames, or frames that `validate` refuses; std::runtime_error that names the
///     path and the reason
DRENCH_API void writeObj(const std::filesystem::path& path, const std::vector<ClothFrame>& sheets);

/// Writes sheets as one CSV file (RFC 4180, except that lines end with a line feed), with one line per node:
/// `time_s, sheet, node, x_m, y_m, z_m, mass_kg, pore_kg, film_kg, film_m, content_kg_per_kg, saturation, red, green,
/// blue`; film_m is the film thickness on one face, colours are linear. Otherwise as `writeObj`.
/// @param time  value of the column time_s, s
/// @throws also std::invalid_argument for a time that is not finite
DRENCH_API void writeCsv(const std::filesystem::path& path, double time,
                         const std::vector<ClothFrame>& sheets);

/// Path of one file of a sequence: `run/cloth.obj` becomes `run/cloth.0012.obj`. At least four digits.
/// @throws std::invalid_argument for a number below 0
DRENCH_API std::filesystem::path numbered(const std::filesystem::path& path, int number);

}  // namespace drench
