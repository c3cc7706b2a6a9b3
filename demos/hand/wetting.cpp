#include "hand/wetting.h"

#include "stage/stage.h"

namespace drench::demo {

void wetTo(WetCloth& cloth, double saturation) {
    Supply& byHand = cloth.account("by hand");
    const Moisture& water = cloth.moisture();
    for (std::size_t n = 0; n < water.size(); ++n) {
        if (!(water.area(n) > 0)) continue;
        byHand.takeFilm(n, water.filmMass()[n]);
        const double missing = saturation * water.poreCapacity(n) - water.poreMass()[n];
        if (missing > 0)
            byHand.addPores(n, missing);
        else
            byHand.takePores(n, -missing);
    }
}

std::vector<WetCloth*> wettable(Scene& scene) {
    std::vector<WetCloth*> cloths;
    for (Stage* const stage : scene.stages())
        if (stage->hasWater())
            for (SceneCloth* const sheet : stage->sheets()) cloths.push_back(&sheet->wet());
    return cloths;
}

void wetTo(Scene& scene, double saturation) {
    for (WetCloth* const cloth : wettable(scene)) wetTo(*cloth, saturation);
}

}  // namespace drench::demo
