#include "scenes/registry.h"

#include <stdexcept>

#include "scenes/described_scene.h"
#include "scenes/makers.h"

namespace drench::demo {

const std::vector<SceneEntry>& scenes() {
    static const std::vector<SceneEntry> all = {
        {"ten-steps",
         "a hanging sheet takes up water in ten steps up to saturation; each is measured in still air and "
         "wind",
         true, makeTenSteps},
        {"rain", "a sheet half under a roof while it rains", false, makeHalfUnderRoof},
        {"spill", "water poured on the middle of a tablecloth spreads", false, makeSpill},
        {"flag", "a dry and a wet flag in the same wind", false, makeFlag},
        {"pool", "a sheet is dipped into a tank of water, lifted out, and drips", false, makeDip},
        {"slide", "a dry, a damp and a soaked sheet on smooth slopes of 20 degrees", false, makeSlide,
         "polyester"},
        {"cling", "a wet and a dry sheet on turning balls", false, makeCling},
        {"drape", "a wet and a dry sheet fall on a ball each", true, makeDrape},
        {"drape-meter",
         "a disc of cloth, dry and wet, hangs over a pedestal (Cusick); prints drape coefficient and nodes",
         false, makeDrapeMeter},
        {"fold", "a towel is folded in four by two grippers, and water is poured on it", false, makeFold},
        {"heap", "laundry of three fabrics falls into a basket, dry and wet", false, makeHeap, ""},
        {"wring",
         "a soaked towel is wrung between two turning clamps, and opens again; CSV of torque, dripped water "
         "and pick-up",
         false, makeWring},
        {"wick",
         "a strip with its foot in water; prints height against time and the fitted Washburn coefficient",
         false, makeWick},
        {"stock-and-drench",
         "a sheet hung by two corners: stock Bullet, Drench dry and wet, each in one substep a frame", false,
         makeStockAndDrench},
        {"clothesline",
         "soaked laundry drips, then dries in time-lapse; CSV of mass, film, pores, dripped, evaporated",
         false, makeClothesline},
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

std::unique_ptr<Scene> makeScene(const std::string& name, const SceneOptions& options) {
    const SceneEntry& entry = sceneByName(name);
    if (options.world != WorldKind::deformable || entry.runsDeformable) return entry.make(options);
    std::string able;
    for (const SceneEntry& each : scenes())
        if (each.runsDeformable) able += (able.empty() ? "" : ", ") + each.name;
    throw std::invalid_argument("scene '" + name +
                                "' does not run in the deformable world; these do: " + able);
}

std::unique_ptr<Scene> makeScene(const SceneDescription& description, const SceneOptions& options) {
    return std::make_unique<DescribedScene>(description, options);
}

}  // namespace drench::demo
