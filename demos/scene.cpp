#include "scene.h"

#include <stdexcept>

#include "scenes/clothesline.h"
#include "scenes/drape.h"
#include "scenes/rain.h"
#include "scenes/spill.h"
#include "scenes/ten_steps.h"
#include "scenes/wick.h"

namespace drench::demo {

const std::vector<SceneEntry>& scenes() {
    static const std::vector<SceneEntry> all = {
        {"ten-steps",
         "a hanging sheet takes up water in ten steps up to saturation; each is measured in still air and "
         "wind",
         [](const SceneOptions& options) -> std::unique_ptr<Scene> {
             return std::make_unique<TenSteps>(options);
         }},
        {"rain", "a sheet half under a roof while it rains",
         [](const SceneOptions& options) -> std::unique_ptr<Scene> {
             return std::make_unique<HalfUnderRoof>(options);
         }},
        {"spill", "water poured on the middle of a tablecloth spreads",
         [](const SceneOptions& options) -> std::unique_ptr<Scene> {
             return std::make_unique<Spill>(options);
         }},
        {"drape", "a wet and a dry sheet fall on a ball each",
         [](const SceneOptions& options) -> std::unique_ptr<Scene> {
             return std::make_unique<Drape>(options);
         }},
        {"wick",
         "a strip with its foot in water; prints height against time and the fitted Washburn coefficient",
         [](const SceneOptions& options) -> std::unique_ptr<Scene> {
             return std::make_unique<Wick>(options);
         }},
        {"clothesline",
         "soaked laundry drips, then dries in time-lapse; CSV of mass, film, pores, dripped, evaporated",
         [](const SceneOptions& options) -> std::unique_ptr<Scene> {
             return std::make_unique<Clothesline>(options);
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
