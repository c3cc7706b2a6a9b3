// Snapshots: a run that was saved and restored is to the last bit the one that never was.
#include <drench/snapshot.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "snapshot_rig.h"

namespace drench::snapshot_test {
namespace {

using test::Mover;
using test::WetScene;
using Build = std::unique_ptr<WetScene> (*)(Mover);

// Everything of the sheets as of now; of unlike states also where they first differ.
std::vector<std::string> bytesOf(const WetScene& scene) {
    std::vector<std::string> all;
    for (const Snapshot& snapshot : scene.save()) all.push_back(snapshot.bytes());
    return all;
}

std::vector<std::string> futureOf(WetScene& scene, int steps) {
    scene.step(steps);
    return bytesOf(scene);
}

// Where two states first differ: section, and byte in it.
std::string difference(const std::string& one, const std::string& other) {
    const Snapshot a(one), b(other);
    StateReader left(a.state()), right(b.state());
    while (left.left() > 0 && right.left() > 0) {
        const std::string name(left.readBytes(4));
        right.readBytes(4);
        const std::string here = left.readText(), there = right.readText();
        if (here == there) continue;
        const auto at =
            std::mismatch(here.begin(), here.begin() + std::min(here.size(), there.size()), there.begin());
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
    for (const int steps : {1, 1, 98, 100}) {
        scene->step(steps);
        fresh->step(steps);
        const auto here = bytesOf(*scene), there = bytesOf(*fresh);
        for (std::size_t i = 0; i < here.size(); ++i)
            ASSERT_TRUE(here[i] == there[i])
                << "sheet " << i << " after " << steps << " more steps; " << difference(here[i], there[i]);
    }
}

// Contacts of the last step with solids and other sheets.
int contactsOf(const btSoftBody& sheet) {
    return sheet.m_rcontacts.size() + sheet.m_scontacts.size() + sheet.m_nodeRigidContacts.size() +
           sheet.m_faceNodeContacts.size();
}

struct SnapshotOfWhatTouches : SnapshotOf {};

TEST_P(SnapshotOfWhatTouches, IsTakenDuringContacts) {
    const auto scene = GetParam().build(GetParam().mover);
    scene->step(GetParam().before);
    EXPECT_GT(contactsOf(scene->sheet()), 0);
}

TEST_P(SnapshotOf, TheSamePresentHasTheSameFutureThreeTimes) {
    const auto scene = GetParam().build(GetParam().mover);
    scene->step(GetParam().before);
    const std::vector<Snapshot> saved = scene->save();
    const auto future = futureOf(*scene, 40);
    for (int i = 0; i < 3; ++i) {
        scene->restore(saved);
        ASSERT_TRUE(futureOf(*scene, 40) == future) << "the " << i + 1 << ". time";
    }
}

const std::vector<Case> hanging = {{"HangingInSmallSteps", test::hangingInRain, Mover::smallSteps, 60},
                                   {"HangingInStock", test::hangingInRain, Mover::stock, 200},
                                   {"HangingExplicit", test::hangingInRain, Mover::explicitSteps, 200},
                                   {"HangingImplicit", test::hangingInRain, Mover::implicitSteps, 60}};
const std::vector<Case> touching = {{"LyingInSmallSteps", test::lyingOnBall, Mover::smallSteps, 40},
                                    {"LyingInStock", test::lyingOnBall, Mover::stock, 200},
                                    {"LyingExplicit", test::lyingOnBall, Mover::explicitSteps, 200},
                                    {"LyingImplicit", test::lyingOnBall, Mover::implicitSteps, 60},
                                    {"TwoInSmallSteps", test::twoSheets, Mover::smallSteps, 40},
                                    {"TwoInStock", test::twoSheets, Mover::stock, 200},
                                    {"TwoExplicit", test::twoSheets, Mover::explicitSteps, 200},
                                    {"TwoImplicit", test::twoSheets, Mover::implicitSteps, 60}};
const auto nameOf = [](const auto& each) { return each.param.name; };
INSTANTIATE_TEST_SUITE_P(Hanging, SnapshotOf, testing::ValuesIn(hanging), nameOf);
INSTANTIATE_TEST_SUITE_P(Touching, SnapshotOf, testing::ValuesIn(touching), nameOf);
INSTANTIATE_TEST_SUITE_P(Touching, SnapshotOfWhatTouches, testing::ValuesIn(touching), nameOf);

void expectSameFuture(WetScene& one, WetScene& other, int steps) {
    for (int step = 1; step <= steps; ++step) {
        one.step(1);
        other.step(1);
        if (step % 20 != 0 && step > 3) continue;
        const auto here = bytesOf(one), there = bytesOf(other);
        for (std::size_t i = 0; i < here.size(); ++i)
            ASSERT_TRUE(here[i] == there[i])
                << "after " << step << " steps " << difference(here[i], there[i]);
    }
}

TEST(SnapshotRun, FiveHundredStepsOnAFile) {
    const auto scene = test::hangingInRain(Mover::smallSteps), fresh = test::hangingInRain(Mover::smallSteps);
    scene->step(100);
    const auto file = std::filesystem::temp_directory_path() / "drench-run.snapshot";
    writeSnapshot(file, scene->cloth().snapshot());
    fresh->cloth().restore(readSnapshot(file));
    std::filesystem::remove(file);
    scene->step(500);
    fresh->step(500);
    EXPECT_TRUE(bytesOf(*scene) == bytesOf(*fresh));
}

// Held by one edge, level at first, and now on its way down.
std::unique_ptr<WetScene> tethered(Mover mover) {
    SmallStepSettings steps;
    steps.count = 6;
    steps.tethers = true;
    auto scene = std::make_unique<WetScene>(mover, steps);
    Fabric wool = fabrics::wool();
    wool.bendingFriction = 1e-5;  // so little that it slides
    auto sheet = test::levelSheet(scene->world().worldInfo(), wool, 0.3, 9, 0);
    for (int n = 0; n < 9; ++n) sheet->m_nodes[n].m_im = 0;
    scene->cover(scene->add(std::move(sheet)), wool).soakFilm(0.3);
    return scene;
}

TEST(SnapshotRun, ASheetThatSleepsWakesAtTheSameMoment) {
    const auto build = [] {
        auto scene = std::make_unique<WetScene>(Mover::smallSteps);
        scene->world().addGround(0);
        const Fabric fabric = fabrics::cottonPlain();
        btSoftBody& sheet = scene->add(test::levelSheet(scene->world().worldInfo(), fabric, 0.3, 9, 0));
        sheet.translate({0, sheet.getCollisionShape()->getMargin(), 0});
        scene->cover(sheet, fabric).add(TimedSoak({40}, 4e-4, 5));
        return scene;
    };
    const auto scene = build(), fresh = build();
    scene->step(61);
    scene->sheet().forceActivationState(ISLAND_SLEEPING);
    scene->step(3);
    ASSERT_FALSE(scene->sheet().isActive());
    fresh->restore(scene->save());
    EXPECT_FALSE(fresh->sheet().isActive());
    expectSameFuture(*scene, *fresh, 60);
    EXPECT_TRUE(scene->sheet().isActive()) << "water should have woken it";
}

TEST(SnapshotRun, ShelterFromWindIsAskedForInTurn) {
    const auto build = [] {
        auto scene = std::make_unique<WetScene>(Mover::smallSteps);
        scene->world().addBall({0, btScalar(-0.3), btScalar(-0.3)}, 0.15, 0);
        const Fabric fabric = fabrics::cottonPlain();
        WetCloth& cloth =
            scene->cover(scene->add(test::hangingSheet(scene->world().worldInfo(), fabric, 0.6, 28)), fabric);
        cloth.air().wind = {0, 0, 4};
        cloth.air().shelterLength = 1;
        return scene;
    };
    const auto scene = build(), fresh = build();
    scene->step(10);
    fresh->restore(scene->save());
    expectSameFuture(*scene, *fresh, 20);
}

TEST(SnapshotRun, TethersAndBendingFrictionGoOn) {
    const auto scene = tethered(Mover::smallSteps), fresh = tethered(Mover::smallSteps);
    scene->step(50);
    fresh->restore(scene->save());
    expectSameFuture(*scene, *fresh, 60);
}

TEST(SnapshotRun, PinsComeBackAsTheyWere) {
    const auto scene = tethered(Mover::smallSteps);
    scene->step(20);
    const auto saved = scene->save();
    for (int n = 0; n < 9; ++n) scene->sheet().m_nodes[n].m_im = scene->sheet().m_nodes[20].m_im;
    scene->step(20);
    scene->restore(saved);
    EXPECT_EQ(scene->sheet().m_nodes[0].m_im, 0);
    const auto fresh = tethered(Mover::smallSteps);
    fresh->restore(saved);
    expectSameFuture(*scene, *fresh, 40);
}

TEST(SnapshotRun, WaterThatTheApplicationAddsBetweenStepsIsNotLost) {
    const auto scene = test::lyingOnBall(Mover::smallSteps), fresh = test::lyingOnBall(Mover::smallSteps);
    scene->step(30);
    scene->cloth().addWater(60, 1e-3, {0, -3, 0});
    scene->cloth().account("jug").cover(5, 0.7);
    scene->cloth().account("jug").submerge(7, 0.02, {0.1, 0, 0});
    fresh->restore(scene->save());
    EXPECT_EQ(fresh->cloth().ledger().supplied, scene->cloth().ledger().supplied);
    expectSameFuture(*scene, *fresh, 40);
}

// Two sheets above each other, of which the upper one drips on the lower.
struct Dripping {
    Dripping() : scene(Mover::smallSteps), drops(scene.world().world()) {
        const Fabric fabric = fabrics::cottonPlain();
        for (const double height : {0.0, -0.4}) {
            auto sheet = test::levelSheet(scene.world().worldInfo(), fabric, 0.3, 7, height);
            for (int n = 0; n < 7; ++n) sheet->m_nodes[n].m_im = 0;
            WetCloth& cloth = scene.cover(scene.add(std::move(sheet)), fabric);
            if (height == 0.0) cloth.soakFilm(1);
            drops.add(cloth);
        }
        scene.everyStep = [this](WetScene&) { drops.step(1.0 / 60); };
    }
    std::string dropsState() const {
        StateWriter writer;
        drops.save(writer);
        return writer.bytes();
    }
    WetScene scene;
    FallingDrops drops;
};

TEST(SnapshotRun, DropsInTheAirGoOnFalling) {
    Dripping one, other;
    one.scene.step(60);
    ASSERT_GT(one.drops.inFlight().size(), 5u);
    other.scene.restore(one.scene.save());
    const std::string state = one.dropsState();
    StateReader reader(state);
    other.drops.load(reader);
    EXPECT_EQ(reader.left(), 0u);
    expectSameFuture(one.scene, other.scene, 60);
    EXPECT_TRUE(one.dropsState() == other.dropsState());
    EXPECT_GT(one.drops.massOnSheets(), 0);
    for (std::size_t size = 0; size < state.size(); size += 5) {
        StateReader cut(std::string_view(state).substr(0, size));
        ASSERT_THROW(other.drops.load(cut), std::runtime_error);
    }
    EXPECT_TRUE(one.dropsState() == other.dropsState());
}

// What an application keeps of a rigid body of its own.
struct RigidState {
    explicit RigidState(const btRigidBody& body)
        : transform(body.getWorldTransform()),
          drawn(body.getInterpolationWorldTransform()),
          velocity(body.getLinearVelocity()),
          spin(body.getAngularVelocity()) {}
    void restore(btRigidBody& body) const {
        body.setWorldTransform(transform);
        body.setInterpolationWorldTransform(drawn);
        for (const bool drawnToo : {false, true}) {
            drawnToo ? body.setInterpolationLinearVelocity(velocity) : body.setLinearVelocity(velocity);
            drawnToo ? body.setInterpolationAngularVelocity(spin) : body.setAngularVelocity(spin);
        }
        body.updateInertiaTensor();
    }
    btTransform transform, drawn;
    btVector3 velocity, spin;
};

// A ball that falls into a hammock, and off it again.
struct Hammock {
    explicit Hammock(Mover mover)
        : scene(mover), ball(scene.world().addBall({0, btScalar(0.08), 0}, 0.05, 0.2)) {
        ball.setActivationState(DISABLE_DEACTIVATION);
        const Fabric fabric = fabrics::cottonPlain();
        auto sheet = test::levelSheet(scene.world().worldInfo(), fabric, 0.4, 11, 0);
        for (const int corner : {0, 10, 110, 120}) sheet->m_nodes[corner].m_im = 0;
        scene.cover(scene.add(std::move(sheet)), fabric).soakPores(0.1);
    }
    WetScene scene;
    btRigidBody& ball;
};

TEST(SnapshotRun, ASolidThatMovesGoesOnWhereTheApplicationRestoresIt) {
    for (const Mover mover : {Mover::smallSteps, Mover::stock}) {
        Hammock one(mover), other(mover);
        one.scene.step(mover == Mover::stock ? 104 : 13);
        ASSERT_GT(contactsOf(one.scene.sheet()), 1);
        RigidState(one.ball).restore(other.ball);
        other.scene.restore(one.scene.save());
        expectSameFuture(one.scene, other.scene, 60);
        EXPECT_TRUE(one.ball.getWorldTransform() == other.ball.getWorldTransform());
    }
}

}  // namespace
}  // namespace drench::snapshot_test
