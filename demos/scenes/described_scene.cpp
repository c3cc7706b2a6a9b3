#include "scenes/described_scene.h"

namespace drench::demo {

void DescribedScene::annotate(viewer::Picture& picture) const {
    if (!title_.empty()) picture.caption.push_back(title_);
}

std::vector<Column> DescribedScene::reportColumns() const {
    std::vector<Column> list = {{"time_s", 1}};
    for (const SceneCloth* sheet : stage().sheets())
        for (const char* what : {"_pores_g", "_film_g", "_dripped_g", "_evaporated_g"})
            list.push_back({sheet->name() + what, 2});
    return list;
}

std::vector<double> DescribedScene::reportRow() const {
    constexpr double grams = 1e3;
    std::vector<double> values = {time()};
    for (const SceneCloth* sheet : stage().sheets()) {
        const Ledger ledger = sheet->wet().ledger();
        const Moisture& moisture = sheet->wet().moisture();
        for (const double mass :
             {moisture.totalPoreMass(), moisture.totalFilmMass(), ledger.dripped, ledger.evaporated})
            values.push_back(grams * mass);
    }
    return values;
}

}  // namespace drench::demo
