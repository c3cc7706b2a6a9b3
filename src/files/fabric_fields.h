// The parameters of a fabric as fields of a JSON object, for fabric files and the fabrics of scene files alike.
#pragma once

#include <drench/fabric.h>

#include <string>
#include <string_view>
#include <vector>

#include "files/json_fields.h"

namespace drench::files {

// Reads a parameter, if it is there: a number in its SI unit, which counts as given, or an object with `value` and, as
// one likes, `unit`, `provenance` and `source`. The value that is there is left alone otherwise.
// @return whether it was there
// @throws std::invalid_argument as FieldReader, also for a unit of another kind of quantity
bool readQuantity(FieldReader& fields, const FabricParameter& parameter, Quantity& quantity);

// The same as JSON: a plain number if it is given and has no source.
nlohmann::ordered_json quantityJson(const FabricParameter& parameter, const Quantity& quantity);

// Reads how the threads hold together, if it is there.
void readConstruction(FieldReader& fields, Construction& construction);

// Whether no law reads a parameter, so that a file may leave it out.
bool isInformationOnly(const FabricParameter& parameter);

// Names of the units that a parameter may have, its SI unit first.
std::vector<std::string> unitsOf(const FabricParameter& parameter);

// "measured", "textbook", "assumed" and "given".
std::vector<std::string> provenanceNames();

// "plain weave", "twill" and "knit".
std::vector<std::string> constructionNames();

}  // namespace drench::files
