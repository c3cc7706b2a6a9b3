// What the fields of a scene file are called, and their ranges; once for reading and writing.
#pragma once

#include "files/json_fields.h"
#include "scene_description.h"

namespace drench::demo {

/// Reads all of a scene. @throws std::invalid_argument as `files::FieldReader`
void exchange(files::FieldReader& fields, SceneDescription& scene);

/// Writes all of a scene.
void exchange(files::FieldWriter& fields, SceneDescription& scene);

}  // namespace drench::demo
