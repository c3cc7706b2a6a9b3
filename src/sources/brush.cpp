#include "drench/brush.h"
#include "checks/checks.h"

namespace drench {

namespace {

void checkSettings(const Brush& brush) {
    checkPosition("Brush::centre", brush.centre);
    checkRange("Brush::radius", brush.radius, "m", 1e-4, 100);
    checkRange("Brush::rate", brush.rate, "kg/(s m2)", 0, 1000);
}

}  // namespace

void Brush::supply(const SheetPose& sheet, double dt, Supply& supply) {
    checkSettings(*this);
    checkStep(dt);
    for (std::size_t node = 0; node < sheet.mesh.size(); ++node) {
        const double distance = (sheet.positions[node] - centre).norm() / radius;
        const double mass = rate * (1 - distance * distance) * sheet.mesh.areas[node] * dt;
        if (mass > 0) supply.addFilm(node, mass);
    }
}

}  // namespace drench
