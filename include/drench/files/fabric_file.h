// Fabrics as JSON files: every value with its unit and provenance.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "drench/config.h"
#include "drench/fabric.h"

namespace drench {

/// Reads a fabric from JSON text: one object, with the keys
/// - `name`, a string; default: that of the base fabric, or "fabric";
/// - `like`, the base fabric for omitted keys, one of `fabrics::names()`; without it all parameters are required except
///   `contactAngle`;
/// - `construction`: "plain weave", "twill" or "knit"; default: that of the base fabric, or "plain weave";
/// - each parameter, by its name in `fabricParameters()`: a number in its SI unit, with the provenance "given", or an
///   object with `value`, `unit` (such as "g/m2" or "mm"; default: the SI unit), `provenance` (default: "given") and
///   `source`, a string that is required if the value is measured. docs/files.md lists the units;
/// - `$schema`, for editors; ignored.
///
/// @throws std::invalid_argument that names the path of the key, as in `thickness.unit`, or line and column of a syntax
///     error, and says what is allowed: for unknown, duplicate or missing keys, values of another type or out of range,
///     units of another kind, fabrics that `validate` refuses, and text of more than 1 MB, 10,000 values or 8 levels
DRENCH_API Fabric fabricFromText(std::string_view text);

/// A fabric as JSON text, from which `fabricFromText` makes a bit-identical fabric.
/// @throws std::invalid_argument for a fabric that `validate` or `fabricFromText` refuses
DRENCH_API std::string fabricText(const Fabric& fabric);

/// Reads a fabric file; see `fabricFromText`.
/// @throws std::runtime_error that names the file and the reason
DRENCH_API Fabric readFabric(const std::filesystem::path& path);

/// Writes a fabric file, atomically; missing parent folders are made.
/// @throws std::invalid_argument as `fabricText`; std::runtime_error that names the path and the reason
DRENCH_API void writeFabric(const std::filesystem::path& path, const Fabric& fabric);

/// JSON Schema (draft 2020-12) of fabric files, for editors and other programs. It checks keys, units, and the ranges
/// of plain numbers, but not whether the values fit each other.
DRENCH_API std::string fabricSchema();

}  // namespace drench
