// Snapshots: a run that was saved and restored is to the last bit the one that never was.
#include <drench/snapshot.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "snapshot_rig.h"

namespace drench {
namespace {

using test::Mover;
using test::WetScene;
using Build = std::unique_ptr<WetScene> (*)(Mover);

/// Everything of the sheets as of now; of unlike states also where they first differ.
std::vector<std::string> bytesOf(const WetScene& scene) {
    std::vector<std::string> all;
    for (const Snapshot& snapshot : scene.save()) all.push_back(snapshot.bytes());
    return all;
}

std::vector<std::string> futureOf(WetScene& scene, int steps) {
    scene.step(steps);
    return bytesOf(scene);
}

/// Where two states first differ: section, and byte in it.
std::string difference(const std::string& one, const std::string& other) {
    const Snapshot a(one), b(other);
    StateReader left(a.state()), right(b.state());
    while (left.left() > 0 && right.left() > 0) {
        const std::string name(left.readBytes(4));
        right.readBytes(4);
        const std::string here = left.readText(), there = right.readText();
        if (here == there) continue;
        const auto at = std::mismatch(here.begin(), here.begin() + std::min(here.size(), there.size()), there.begin());
        return "they differ in " + name + " at byte " + std::to_string(at.first - here.begin()) + " of " +
               std::to_string(here.size()) + " and " + std::to_string(there.size());
    }
    return "they are alike";
}

struct Case {
    const char* name;
    Build build;
    Mover mover;
    int before;  // steps
};

void PrintTo(const Case& each, std::ostream* out) {
    *out << each.name;
}

class SnapshotOf : public testing::TestWithParam<Case> {};

TEST_P(SnapshotOf, AFreshWorldGoesOnAsTheOldOne) {
    const auto scene = GetParam().build(GetParam().mover);
    scene->step(GetParam().before);
    const std::vector<Snapshot> saved = scene->save();
    const auto fresh = GetParam().build(GetParam().mover);
    fresh->restore(saved);
    ASSERT_EQ(bytesOf(*fresh), bytesOf(*scene)) << "restored";
    for (const int steps : {1, 1, 98, 200}) {
        scene->step(steps);
        fresh->step(steps);
        const auto here = bytesOf(*scene), there = bytesOf(*fresh);
        for (std::size_t i = 0; i < here.size(); ++i)
            ASSERT_TRUE(here[i] == there[i]) << "sheet " << i << " after " << steps << " more steps; "
                                             << difference(here[i], there[i]);
    }
}

TEST_P(SnapshotOf, TheSamePresentHasTheSameFutureThreeTimes) {
    const auto scene = GetParam().build(GetParam().mover);
    scene->step(GetParam().before);
    const std::vector<Snapshot> saved = scene->save();
    const auto future = futureOf(*scene, 60);
    for (int i = 0; i < 3; ++i) {
        scene->restore(saved);
        ASSERT_TRUE(futureOf(*scene, 60) == future) << "the " << i + 1 << ". time";
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, SnapshotOf,
    testing::Values(Case{"HangingInSmallSteps", test::hangingInRain, Mover::smallSteps, 60},
                    Case{"HangingInStock", test::hangingInRain, Mover::stock, 200},
                    Case{"HangingExplicit", test::hangingInRain, Mover::explicitSteps, 200},
                    Case{"HangingImplicit", test::hangingInRain, Mover::implicitSteps, 60},
                    Case{"LyingInSmallSteps", test::lyingOnBall, Mover::smallSteps, 40},
                    Case{"LyingInStock", test::lyingOnBall, Mover::stock, 200},
                    Case{"LyingExplicit", test::lyingOnBall, Mover::explicitSteps, 200},
                    Case{"LyingImplicit", test::lyingOnBall, Mover::implicitSteps, 60},
                    Case{"TwoInSmallSteps", test::twoSheets, Mover::smallSteps, 40},
                    Case{"TwoInStock", test::twoSheets, Mover::stock, 200},
                    Case{"TwoExplicit", test::twoSheets, Mover::explicitSteps, 200},
                    Case{"TwoImplicit", test::twoSheets, Mover::implicitSteps, 60}),
    [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace drench
