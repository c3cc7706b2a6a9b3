#include "scenes/registry.h"

#include <stdexcept>

#include "scenes/cling.h"
#include "scenes/clothesline.h"
#include "scenes/described_scene.h"
#include "scenes/drape.h"
#include "scenes/drape_meter.h"
#include "scenes/flag.h"
#include "scenes/pool.h"
#include "scenes/rain.h"
#include "scenes/slide.h"
#include "scenes/spill.h"
#include "scenes/stock_and_drench.h"
#include "scenes/ten_steps.h"
#include "scenes/wick.h"

namespace drench::demo {

namespace {

template <typename Kind>
std::unique_ptr<Scene> make(const SceneOptions& options) {
    return std::make_unique<Kind>(options);
}

}  // namespace

const std::vector<SceneEntry>& scenes() {
    static const std::vector<SceneEntry> all = {
        {"ten-steps",
         "a hanging sheet takes up water in ten steps up to saturation; each is measured in still air and "
         "wind",
         true, make<TenSteps>},
        {"rain", "a sheet half under a roof while it rains", false, make<HalfUnderRoof>},
        {"spill", "water poured on the middle of a tablecloth spreads", false, make<Spill>},
        {"flag", "a dry and a wet flag in the same wind", false, make<Flag>},
        {"pool", "a sheet is dipped into a tank of water, lifted out, and drips", false, make<Dip>},
        {"slide", "a dry, a damp and a soaked sheet on smooth slopes of 20 degrees", false, make<Slide>,
         "polyester"},
        {"cling", "a wet and a dry sheet on turning balls", false, make<Cling>},
        {"drape", "a wet and a dry sheet fall on a ball each", true, make<Drape>},
        {"drape-meter",
         "a disc of cloth, dry and wet, hangs over a pedestal (Cusick); prints drape coefficient and nodes",
         false, make<DrapeMeter>},
        {"wick",
         "a strip with its foot in water; prints height against time and the fitted Washburn coefficient",
         false, make<Wick>},
        {"stock-and-drench",
         "a sheet hung by two corners: stock Bullet, Drench dry and wet, each in one substep a frame", false,
         make<StockAndDrench>},
        {"clothesline",
         "soaked laundry drips, then dries in time-lapse; CSV of mass, film, pores, dripped, evaporated",
         false, make<Clothesline>},
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
