// The list of scenes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "description/scene_description.h"
#include "stage/scene.h"

namespace drench::demo {

// A scene on the list.
struct SceneEntry {
    std::string name;
    std::string description;
    bool runsDeformable;  // also in Bullet's deformable world
    std::unique_ptr<Scene> (*make)(const SceneOptions&);
    std::string fabric = "cotton";  // that suits it, where none is asked for
};

// All scenes.
const std::vector<SceneEntry>& scenes();

// The scene of that name. @throws std::invalid_argument that lists the names there are.
const SceneEntry& sceneByName(const std::string& name);

// Makes the scene of that name.
// @throws std::invalid_argument as `sceneByName`, and for a scene that does not run in the world of the options
std::unique_ptr<Scene> makeScene(const std::string& name, const SceneOptions& options);

// Makes a scene that has nothing but its description, as those of scene files are.
// @throws std::invalid_argument for what cannot be built, naming it
std::unique_ptr<Scene> makeScene(const SceneDescription& description, const SceneOptions& options);

}  // namespace drench::demo
