// What the fields of a sheet are called in a scene file.
#pragma once

#include "scene_description.h"
#include "scene_fields.h"

namespace drench::demo {

/// Reads a sheet. @throws std::invalid_argument as `FieldReader`
void exchangeSheet(FieldReader& fields, SheetDescription& sheet);

/// Writes a sheet.
void exchangeSheet(FieldWriter& fields, SheetDescription& sheet);

}  // namespace drench::demo
