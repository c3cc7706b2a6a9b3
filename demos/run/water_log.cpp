#include "run/water_log.h"

#include <drench/wet_cloth.h>

#include <utility>

namespace drench::demo {

namespace {

double clothArea(const Moisture& moisture) {
    double area = 0;
    for (std::size_t n = 0; n < moisture.size(); ++n) area += moisture.area(n);
    return area;
}

}  // namespace

WaterLog::WaterLog(const Scene& scene) {
    table_.columns = {{"time_s", 2},     {"supplied_kg", 6},   {"pore_kg", 6},     {"film_kg", 6},
                      {"dripped_kg", 6}, {"evaporated_kg", 6}, {"returned_kg", 6}, {"mean_saturation", 4}};
    for (const Column& column : scene.columns()) table_.columns.push_back(column);
}

void WaterLog::note(Scene& scene) {
    double pores = 0, film = 0, filled = 0, area = 0;
    Ledger sum;
    for (const SceneSheet& sheet : scene.sheets()) {
        const Moisture& moisture = sheet.cloth->moisture();
        const Ledger ledger = moisture.ledger();
        sum.supplied += ledger.supplied;
        sum.dripped += ledger.dripped;
        sum.evaporated += ledger.evaporated;
        sum.returned += ledger.returned;
        pores += moisture.totalPoreMass();
        film += moisture.totalFilmMass();
        const double sheetArea = clothArea(moisture);
        filled += moisture.meanSaturation() * sheetArea;
        area += sheetArea;
    }
    std::vector<double> row = {double(table_.rows.size() + 1) * Scene::frameTime,
                               sum.supplied,
                               pores,
                               film,
                               sum.dripped,
                               sum.evaporated,
                               sum.returned,
                               area > 0 ? filled / area : 0.0};
    for (const double value : scene.row()) row.push_back(value);
    table_.rows.push_back(std::move(row));
}

}  // namespace drench::demo
