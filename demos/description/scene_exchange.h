// What the fields of a scene file are called, and their ranges; once for reading and writing.
#pragma once

#include "description/scene_description.h"
#include "files/json_fields.h"

namespace drench::demo {

/// Reads all of a scene. @throws std::invalid_argument as `files::FieldReader`
void exchange(files::FieldReader& fields, SceneDescription& scene);

/// Writes all of a scene.
void exchange(files::FieldWriter& fields, SceneDescription& scene);

}  // namespace drench::demo
