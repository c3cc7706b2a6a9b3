// Scenes as JSON text and files; docs/scene-files.md says what may stand in them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "description/scene_description.h"

namespace drench::demo {

// Reads a scene from JSON text.
// @throws std::invalid_argument that names the key by its path, as in `sheets[1].fabric.stretchWarp`, or line and
//     column where the syntax is broken, and says what may be given
SceneDescription readScene(std::string_view text);

// The scene as JSON text, of which `readScene` makes the same.
std::string sceneText(const SceneDescription& description);

// Reads a scene file.
// @throws std::runtime_error that names the file, and says what is wrong with it as `readScene`
SceneDescription loadScene(const std::filesystem::path& path);

// Writes a scene file, which appears under its name only once it is whole.
// @throws std::runtime_error that names the path and says what is in the way, or the key that has come out of its range
void saveScene(const std::filesystem::path& path, const SceneDescription& description);

}  // namespace drench::demo
