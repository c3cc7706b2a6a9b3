// The parameters of a fabric as fields of a JSON object, for fabric files and scene files.
#pragma once

#include <drench/fabric.h>

#include <string>
#include <string_view>
#include <vector>

#include "files/json_fields.h"

namespace drench::files {

// Reads a parameter, if present: a number in its SI unit, with the provenance "given", or an object with
// `value` and, optionally, `unit`, `provenance` and `source`. If absent, the quantity is not changed.
// @return whether it was present
// @throws std::invalid_argument as FieldReader, also for a unit of another quantity
bool readQuantity(FieldReader& fields, const FabricParameter& parameter, Quantity& quantity);

// Writes the parameter: a plain number if it is "given" and has no source.
nlohmann::ordered_json quantityJson(const FabricParameter& parameter, const Quantity& quantity);

// Reads the construction, if present.
void readConstruction(FieldReader& fields, Construction& construction);

// Whether a file without a base fabric may omit a parameter: no formula uses it, or files of version 0.2 do not have it.
bool isOptional(const FabricParameter& parameter);

// Names of the units of a parameter, its SI unit first.
std::vector<std::string> unitsOf(const FabricParameter& parameter);

// "measured", "textbook", "assumed" and "given".
std::vector<std::string> provenanceNames();

// "plain weave", "twill" and "knit".
std::vector<std::string> constructionNames();

}  // namespace drench::files
