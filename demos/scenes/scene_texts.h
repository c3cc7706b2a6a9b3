// Scene files of the built-in scenes, compiled into the program.
#pragma once

#include <string>

#include "description/scene_description.h"

namespace drench::demo {

// The scene file of that name in demos/scenes. @throws std::out_of_range for an unknown name
SceneDescription sceneFile(const std::string& name);

}  // namespace drench::demo
