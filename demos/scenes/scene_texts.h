// What the scenes on the list consist of.
#pragma once

#include <string>

#include "description/scene_description.h"

namespace drench::demo {

// The scene file of that name in demos/scenes. @throws std::out_of_range for a name that is not there
SceneDescription sceneFile(const std::string& name);

}  // namespace drench::demo
