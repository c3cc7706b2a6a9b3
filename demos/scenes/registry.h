// The list of built-in scenes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "description/scene_description.h"
#include "stage/scene.h"

namespace drench::demo {

// A built-in scene.
struct SceneEntry {
    std::string name;
    std::string description;
    bool runsDeformable;  // also in Bullet's deformable world
    std::unique_ptr<Scene> (*make)(const SceneOptions&);
    std::string fabric = "cotton";  // default fabric
};

// All scenes.
const std::vector<SceneEntry>& scenes();

// The scene of that name. @throws std::invalid_argument that lists the names, for an unknown one
const SceneEntry& sceneByName(const std::string& name);

// Makes the scene of that name.
// @throws std::invalid_argument as `sceneByName`, and for a scene that does not run in the world of the options
std::unique_ptr<Scene> makeScene(const std::string& name, const SceneOptions& options);

// Makes a scene from a description only, such as that of a scene file.
// @throws std::invalid_argument that names what cannot be made
std::unique_ptr<Scene> makeScene(const SceneDescription& description, const SceneOptions& options);

}  // namespace drench::demo
