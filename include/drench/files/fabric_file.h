// Fabrics as JSON: files that keep every value together with its unit and where it is from.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "drench/export.h"
#include "drench/fabric.h"

namespace drench {

/// Reads a fabric from JSON text, one object. Its keys:
/// - `name`, a text; without it the fabric is called as the one that it is like, or "fabric";
/// - `like`, a name of `fabrics::names()`: what is not said is as there. Without it every parameter must be there;
/// - `construction`: "plain weave", "twill" or "knit";
/// - each parameter by its name in `fabricParameters()`: a number in its SI unit, which counts as given, or an object
///   with `value`, `unit` (such as "g/m2" or "mm"; default the SI unit), `provenance` (default "given") and `source`,
///   a text that must be there if it was measured. docs/files.md lists the units;
/// - `$schema`, for editors, which is not looked at.
///
/// @throws std::invalid_argument that names the key by its path, as in `thickness.unit`, or line and column where the
///     syntax is broken, and says what may be given: for keys that are not known, are there twice or are missing,
///     values of another type or out of range, units of another kind, what `validate` refuses, and text of more than
///     1 MB, with more than 10,000 values or more than 8 deep.
DRENCH_API Fabric fabricFromText(std::string_view text);

/// A fabric as JSON text, of which `fabricFromText` makes the same, to the last bit.
/// @throws std::invalid_argument for a fabric that `validate` or `fabricFromText` refuses
DRENCH_API std::string fabricText(const Fabric& fabric);

/// Reads a fabric file, text as in `fabricFromText`.
/// @throws std::runtime_error that names the file, and says what is wrong with it
DRENCH_API Fabric readFabric(const std::filesystem::path& path);

/// Writes a fabric file, which appears under its name only once it is whole; folders above it are made.
/// @throws std::invalid_argument as `fabricText`; std::runtime_error that names the path and says what is in the way
DRENCH_API void writeFabric(const std::filesystem::path& path, const Fabric& fabric);

/// The JSON Schema (draft 2020-12) of fabric files, for editors and other programs. It knows keys, units, and the
/// ranges of plain numbers; how values must fit each other it does not.
DRENCH_API std::string fabricSchema();

}  // namespace drench
