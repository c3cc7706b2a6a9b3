#include "scene.h"

#include <stdexcept>

#include "scenes/drape.h"
#include "scenes/ten_steps.h"

namespace drench::demo {

const std::vector<SceneEntry>& scenes() {
    static const std::vector<SceneEntry> all = {
        {"ten-steps",
         "a hanging sheet takes up water in ten steps up to saturation; each is measured in still air and "
         "wind",
         [](const SceneOptions& options) -> std::unique_ptr<Scene> {
             return std::make_unique<TenSteps>(options);
         }},
        {"drape", "a wet and a dry sheet fall on a ball each",
         [](const SceneOptions& options) -> std::unique_ptr<Scene> {
             return std::make_unique<Drape>(options);
         }},
    };
    return all;
}

const SceneEntry& sceneByName(const std::string& name) {
    std::string known;
    for (const SceneEntry& entry : scenes()) {
        if (entry.name == name) return entry;
        known += (known.empty() ? "" : ", ") + entry.name;
    }
    throw std::invalid_argument("no scene named '" + name + "'; there are " + known);
}

}  // namespace drench::demo
