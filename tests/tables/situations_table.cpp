// Prints the table of docs/touch-and-air.md: what cloth does in the situations of games and robots, in the soft-rigid world
// with small steps, with the stock solver (without height fields), and in the deformable world. Takes an hour.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bullet/contact/situations.h"

namespace drench::test {
namespace {

// The worst of all shapes, and the shape.
struct Worst {
    double deepest = 0, speed = 0, momentum = 0;
    SolidForm form = SolidForm::ball;
    bool finite = true;
};

Worst worstOf(SolidKind kind, SolidLoad load, StepWorld world) {
    Worst worst;
    for (const SolidForm form : allForms()) {
        // Bullet's own search takes minutes a frame on a height field of 2,048 triangles.
        if (world == StepWorld::stock && form == SolidForm::heightField) continue;
        const Outcome found = play({kind, form, load, world});
        if (found.deepest > worst.deepest) worst.form = form;
        worst.deepest = std::max(worst.deepest, found.deepest);
        worst.speed = std::max(worst.speed, found.speed);
        worst.momentum = std::max(worst.momentum, found.momentum);
        worst.finite = worst.finite && found.finite;
    }
    return worst;
}

void printRow(SolidKind kind, SolidLoad load) {
    std::printf("| %s | %s |", nameOf(kind).c_str(), nameOf(load).c_str());
    for (const StepWorld world : {StepWorld::smallSteps, StepWorld::stock, StepWorld::deformable}) {
        const Worst worst = worstOf(kind, load, world);
        if (worst.deepest > 5e-5)
            std::printf(" %.1f mm (%s) |", 1e3 * worst.deepest, nameOf(worst.form).c_str());
        else
            std::printf(" 0 |");
        const bool isCalm = load == SolidLoad::rest || load == SolidLoad::passing;
        if (!worst.finite)
            std::printf(" not finite |");
        else if (isCalm)
            std::printf(" %.2g mm/s |", 1e3 * worst.speed);
        else if (worst.momentum > 0)
            std::printf(" %.2g %% lost |", 100 * worst.momentum);
        else
            std::printf(" |");
    }
    std::printf("\n");
    std::fflush(stdout);
}

}  // namespace
}  // namespace drench::test

int main() {
    using namespace drench::test;
    std::printf(
        "| solid | motion | deepest node, small steps | speed or momentum | deepest node, stock | speed or "
        "momentum | deepest node, deformable | speed or momentum |\n");
    std::printf("|-|-|-|-|-|-|-|-|\n");
    for (const SolidKind kind : allKinds())
        for (const SolidLoad load : allLoads()) printRow(kind, load);
}
