#include "wetting.h"

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

void wetTo(Scene& scene, double saturation) {
    for (const SceneSheet& sheet : scene.sheets()) wetTo(*sheet.cloth, saturation);
}

}  // namespace drench::demo
