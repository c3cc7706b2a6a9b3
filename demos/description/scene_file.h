// Scenes as JSON text and files; docs/scene-files.md lists the keys.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "description/scene_description.h"

namespace drench::demo {

// Reads a scene from JSON text.
// @throws std::invalid_argument with the path of the key, as in `sheets[1].fabric.stretchWarp`, or line and
//     column of a syntax error, and the valid values
SceneDescription readScene(std::string_view text);

// The scene as JSON text, from which `readScene` makes the same scene.
std::string sceneText(const SceneDescription& description);

// Reads a scene file.
// @throws std::runtime_error with the name of the file and the reason, as `readScene`
SceneDescription loadScene(const std::filesystem::path& path);

// Writes a scene file, atomically.
// @throws std::runtime_error with the path and the reason, or the key whose value is out of range
void saveScene(const std::filesystem::path& path, const SceneDescription& description);

}  // namespace drench::demo
