// What the fields of a sheet are called in a scene file.
#pragma once

#include "description/scene_description.h"
#include "files/json_fields.h"

namespace drench::demo {

/// Reads a sheet. @throws std::invalid_argument as `files::FieldReader`
void exchangeSheet(files::FieldReader& fields, SheetDescription& sheet);

/// Writes a sheet.
void exchangeSheet(files::FieldWriter& fields, SheetDescription& sheet);

}  // namespace drench::demo
