// Any bytes as a snapshot; and the state of a sheet, changed at any places, under a checksum that is right.
#include <drench/snapshot.h>

#include <string>

#include "bullet/state/snapshot_rig.h"
#include "choices.h"
#include "state/snapshot_bytes.h"

namespace drench::fuzz {
namespace {

std::unique_ptr<test::WetScene> scene(test::Mover mover) {
    auto made = std::make_unique<test::WetScene>(mover);
    made->world().addBall({0, btScalar(-0.05), 0}, 0.05, 0);
    const Fabric fabric = fabrics::cottonPlain();
    WetCloth& cloth =
        made->cover(made->add(test::levelSheet(made->world().worldInfo(), fabric, 0.1, 3, 0.01)), fabric);
    cloth.add(Rain(100));
    cloth.soakPores(0.2);
    made->step(4);
    return made;
}

Snapshot changed(const Snapshot& snapshot, Choices& choices) {
    std::string state(snapshot.state());
    while (choices.any()) {
        const auto position = std::size_t(choices.byte()) << 8 | choices.byte();
        if (choices.oneIn(32)) state.resize(position % (state.size() + 1));
        if (!state.empty()) state[position % state.size()] = static_cast<char>(choices.byte());
    }
    return Snapshot(snapshotBytes(
        {snapshot.precision(), snapshot.nodes(), snapshot.links(), snapshot.faces(), snapshot.topology()},
        state));
}

}  // namespace
}  // namespace drench::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    using namespace drench;
    fuzz::accepts([&] { Snapshot(std::string(bytes, bytes + count)); });

    fuzz::Choices choices(bytes, count);
    const auto scene = fuzz::scene(static_cast<test::Mover>(choices.whole(0, 2)));
    WetCloth& cloth = scene->cloth();
    const Snapshot before = cloth.snapshot();
    const Snapshot after = fuzz::changed(before, choices);
    if (!fuzz::accepts([&] { cloth.restore(after); })) {
        if (cloth.snapshot().bytes() != before.bytes()) fuzz::fail("refused, and the sheet has changed");
        return 0;
    }
    scene->step(3);
    // Bullet's own solvers may blow up on a wild state within a step; the next one mends that.
    if (scene->mover() == test::Mover::smallSteps && !cloth.health().finite)
        fuzz::fail("restored to what is not finite");
    return 0;
}
