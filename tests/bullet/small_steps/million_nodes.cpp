// A sheet of a million nodes in a real world: half a minute and 4 GB. Run by ctest -C slow -L slow.
#include <drench/drench.h>

#include <chrono>
#include <cmath>
#include <cstdio>

#include "bullet/world/worlds.h"

int main() {
    using Clock = std::chrono::steady_clock;
    auto last = Clock::now();
    const auto say = [&last](const char* what) {
        const auto now = Clock::now();
        std::printf("%-8s %6.2f s\n", what, std::chrono::duration<double>(now - last).count());
        last = now;
    };
    constexpr int side = 1000;
    drench::test::SmallStepWorld rig({4, 0.01});
    btSoftBody& sheet =
        rig.add(drench::test::hangingSheet(rig.info(), drench::fabrics::cottonPlain(), 10, side));
    sheet.m_cfg.collisions |= btSoftBody::fCollision::VF_SS;
    say("made");
    drench::WetCloth& cloth = rig.cover(sheet, drench::fabrics::cottonPlain());
    say("attached");
    cloth.soakFilm(0.3);
    for (int step = 0; step < 3; ++step) {
        rig.run(1.0 / 60);
        say("stepped");
    }
    const drench::Ledger water = cloth.ledger();
    const drench::SheetHealth health = cloth.health();
    const bool isClosed = std::abs(water.imbalance()) < 1e-9 * water.supplied;
    std::printf("finite %d, closed %d, kinds of trouble %d\n", health.finite, isClosed, health.troubles);
    return health.finite && isClosed && health.troubles == 0 ? 0 : 1;
}
