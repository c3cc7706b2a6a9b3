// What is no snapshot of a sheet is refused with the reason, and leaves the sheet as it was.
#include <drench/snapshot.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "snapshot_rig.h"
#include "state/checksum.h"
#include "state/snapshot_bytes.h"

namespace drench::snapshot_refusal_test {
namespace {

using test::Mover;
using test::WetScene;

// A wet sheet of 5 x 5 nodes in rain, on its way down.
std::unique_ptr<WetScene> smallScene(const Fabric& fabric = fabrics::cottonPlain(), int nodes = 5,
                                     Mover mover = Mover::smallSteps) {
    auto scene = std::make_unique<WetScene>(mover);
    scene->world().addBall({0, btScalar(-0.05), 0}, 0.05, 0);
    WetCloth& cloth = scene->cover(
        scene->add(test::levelSheet(scene->world().worldInfo(), fabric, 0.1, nodes, 0.01)), fabric);
    cloth.add(Rain(100));
    cloth.soakPores(0.2);
    return scene;
}

// The first bytes again, with a checksum that fits.
std::string sealed(std::string bytes) {
    bytes.resize(bytes.size() - 8);
    StateWriter writer;
    writer.writeBytes(bytes);
    writer.write(checksumOf(bytes));
    return writer.bytes();
}

// With another state, and all else right.
std::string withState(const Snapshot& of, const std::string& state) {
    return snapshotBytes({of.precision(), of.nodes(), of.links(), of.faces(), of.topology()}, state);
}

template <typename Act>
std::string reasonOf(Act act) {
    try {
        act();
    } catch (const std::exception& problem) {
        return problem.what();
    }
    return "";
}

#define EXPECT_SAYS(act, part) EXPECT_PRED2(contains, reasonOf([&] { act; }), part)

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

struct SnapshotRefusal : testing::Test {
    SnapshotRefusal() {
        scene->step(30);
        before = scene->cloth().snapshot().bytes();
    }
    ~SnapshotRefusal() override {
        EXPECT_TRUE(scene->cloth().snapshot().bytes() == before) << "sheet touched";
    }

    std::unique_ptr<WetScene> scene = smallScene();
    std::string before;
};

TEST_F(SnapshotRefusal, CutOffAnywhere) {
    for (std::size_t size = 0; size < before.size(); ++size)
        ASSERT_THROW(Snapshot(before.substr(0, size)), std::runtime_error) << size;
    EXPECT_SAYS(Snapshot(""), "it is empty");
    EXPECT_SAYS(Snapshot(before.substr(0, 20)), "cut off");
    EXPECT_SAYS(Snapshot(before.substr(0, before.size() - 1)), "was cut off");
    EXPECT_SAYS(Snapshot(before + "x"), "something was added to it");
}

TEST_F(SnapshotRefusal, AnyBitThatHasChanged) {
    for (std::size_t bit = 0; bit < 8 * before.size(); ++bit) {
        std::string changed = before;
        changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
        ASSERT_THROW(Snapshot{changed}, std::runtime_error) << bit;
    }
    std::string changed = before;
    changed[before.size() / 2] ^= 1;
    EXPECT_SAYS(Snapshot{changed}, "its checksum does not fit");
}

TEST_F(SnapshotRefusal, OtherKindsAndNewerFormats) {
    std::string other = before;
    other[1] = 'P';
    EXPECT_SAYS(Snapshot{other}, "some other file");
    EXPECT_SAYS(Snapshot(std::string(1000, '\0')), "some other file");
    std::string newer = before;
    newer[8] = 3;
    EXPECT_SAYS(Snapshot(sealed(newer)), "its format is 3, and this library knows formats up to 2");
    std::string odd = before;
    odd[12] = 6;
    EXPECT_SAYS(Snapshot(sealed(odd)), "its numbers have 6 bytes");
    std::string huge = before;
    huge[23] = 127;
    EXPECT_SAYS(Snapshot(sealed(huge)), "it should have 91513");
}

TEST_F(SnapshotRefusal, ForeignSheets) {
    const auto refusedFrom = [&](const WetScene& foreign) {
        return reasonOf([&] { scene->cloth().restore(foreign.save()[0]); });
    };
    EXPECT_PRED2(contains, refusedFrom(*smallScene(fabrics::cottonPlain(), 6)),
                 "36 nodes, and this one has 25");
    EXPECT_PRED2(contains, refusedFrom(*smallScene(fabrics::wool())), "arealDensity of its fabric");
    EXPECT_PRED2(contains, refusedFrom(*smallScene(fabrics::cottonPlain(), 5, Mover::explicitSteps)),
                 "in a deformable world");

    auto turned = std::make_unique<WetScene>(Mover::smallSteps);
    auto longer = std::make_unique<WetScene>(Mover::smallSteps);
    const Fabric cotton = fabrics::cottonPlain();
    turned->cover(
        turned->add(makeSheet(turned->world().worldInfo(), cotton,
                              flatCorners({0, 0, 0}, {0, 0, btScalar(0.1)}, {btScalar(0.1), 0, 0}), 3, 11)),
        cotton);
    longer->cover(longer->add(test::levelSheet(longer->world().worldInfo(), cotton, 0.11, 5, 0.01)), cotton);
    EXPECT_PRED2(contains, refusedFrom(*turned), "nodes");
    EXPECT_PRED2(contains, refusedFrom(*longer), "the end of link 0 is at");

    const std::string other =
        before.substr(0, 12) + (sizeof(btScalar) == 4 ? '\x8' : '\x4') + before.substr(13);
    EXPECT_SAYS(scene->cloth().restore(Snapshot(sealed(other))),
                "-precision Bullet, and this library is for");
}

TEST_F(SnapshotRefusal, OtherSourcesAndSolids) {
    auto pooled = smallScene();
    pooled->cloth().add(Pool(-1));
    EXPECT_SAYS(scene->cloth().restore(pooled->cloth().snapshot()), "it has 2 sources, and this one has 1");

    WetScene dry(Mover::smallSteps), bare(Mover::smallSteps);
    dry.world().addBall({0, btScalar(-0.05), 0}, 0.05, 0);
    const Fabric cotton = fabrics::cottonPlain();
    for (WetScene* each : {&dry, &bare})
        each->cover(each->add(test::levelSheet(each->world().worldInfo(), cotton, 0.1, 5, 0.01)), cotton);
    dry.cloth().add(Pool(-1));
    bare.cloth().add(Rain(100));
    ASSERT_GT(scene->sheet().m_rcontacts.size(), 0);
    EXPECT_SAYS(dry.cloth().restore(Snapshot(before)), "is of the name rain, and this one's is pool");
    EXPECT_SAYS(bare.cloth().restore(Snapshot(before)), "object 0 of this world is a soft body");
}

// A source of the application's own, which takes only states that begin with 7.
class Picky final : public Source {
  public:
    std::string name() const override { return "picky"; }
    void supply(const SheetPose&, double, Supply&) override {}
    void save(StateWriter& writer) const override { writer.write(value); }
    void load(StateReader& reader) override {
        const auto read = reader.read<double>();
        if (read != 7) throw std::runtime_error("the picky source likes 7 alone");
        value = read;
    }
    double value = 7;
};

TEST(SnapshotSources, NoneIsRestoredWhereOneRefuses) {
    auto scene = smallScene();
    Picky& picky = scene->cloth().add(Picky());
    scene->step(20);
    picky.value = 8;
    const Snapshot unloadable = scene->cloth().snapshot();
    picky.value = 7;
    scene->step(20);
    const std::string before = scene->cloth().snapshot().bytes();
    EXPECT_SAYS(scene->cloth().restore(unloadable), "the picky source likes 7 alone");
    EXPECT_TRUE(scene->cloth().snapshot().bytes() == before);
}

TEST(SnapshotSources, WithinAStepThereIsNoState) {
    struct Meddling final : Source {
        explicit Meddling(const WetCloth& its) : cloth(&its) {}
        std::string name() const override { return "meddling"; }
        void supply(const SheetPose&, double dt, Supply&) override {
            if (dt > 0) cloth->snapshot();
        }
        const WetCloth* cloth;
    };
    auto scene = smallScene();
    scene->cloth().add(Meddling(scene->cloth()));
    scene->step(1);
    ASSERT_EQ(scene->cloth().troubles().size(), 1u);
    EXPECT_NE(scene->cloth().troubles()[0].message.find("within a step"), std::string::npos);
}

TEST(SnapshotSources, ABodyInNoWorldHasNone) {
    auto scene = smallScene();
    const Snapshot snapshot = scene->cloth().snapshot();
    scene->world().removeSoftBody(scene->sheet());
    EXPECT_THROW(scene->cloth().snapshot(), std::logic_error);
    EXPECT_THROW(scene->cloth().restore(snapshot), std::logic_error);
    scene->world().addSoftBody(scene->sheet());
}

// Whatever stands in a state that claims to be right, it is refused, or the sheet takes it and goes on from there.
TEST(SnapshotNonsense, UnderARightChecksum) {
    auto scene = smallScene();
    scene->step(30);
    const Snapshot good = scene->cloth().snapshot();
    scene->step(10);
    const auto future = scene->cloth().snapshot().hash();
    const std::string state(good.state());
    int refused = 0;
    for (std::size_t at = 0; at + 4 <= state.size(); at += 7) {
        for (const std::uint32_t nonsense : {0x7fc00000u, 0xffffffffu, 0x7f7fffffu, 0u}) {
            std::string changed = state;
            std::memcpy(&changed[at], &nonsense, sizeof nonsense);
            try {
                scene->cloth().restore(Snapshot(withState(good, changed)));
            } catch (const std::runtime_error&) {
                ++refused;
            }
            ASSERT_TRUE(test::isFinite(scene->sheet())) << at;
        }
    }
    EXPECT_GT(refused, static_cast<int>(state.size() / 10));
    scene->cloth().restore(good);
    scene->step(10);
    EXPECT_EQ(scene->cloth().snapshot().hash(), future);
}

struct SnapshotFile : testing::Test {
    SnapshotFile() { std::filesystem::create_directories(folder); }
    ~SnapshotFile() override { std::filesystem::remove_all(folder); }
    void write(const std::string& name, const std::string& contents) const {
        std::ofstream(folder / name, std::ios::binary) << contents;
    }
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() /
        ("drench-snapshot-" + std::to_string(reinterpret_cast<std::uintptr_t>(this)));
};

TEST_F(SnapshotFile, ComesBackAsItWas) {
    const Snapshot snapshot = smallScene()->cloth().snapshot();
    writeSnapshot(folder / "new" / "sheet.snapshot", snapshot);
    writeSnapshot(folder / "new" / "sheet.snapshot", snapshot);
    EXPECT_TRUE(readSnapshot(folder / "new" / "sheet.snapshot").bytes() == snapshot.bytes());
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "new"))
        files += entry.is_regular_file() ? 1 : 0;
    EXPECT_EQ(files, 1);
}

TEST_F(SnapshotFile, SaysWhyItCannotBeRead) {
    write("empty", "");
    write("text", "Lorem ipsum dolor sit amet");
    EXPECT_SAYS(readSnapshot(folder / "none"), "none: it is not there");
    EXPECT_SAYS(readSnapshot(folder), "it is no file");
    EXPECT_SAYS(readSnapshot(folder / "empty"), "it is empty");
    EXPECT_SAYS(readSnapshot(folder / "text"), "some other file");
    EXPECT_SAYS(writeSnapshot(folder, smallScene()->cloth().snapshot()), "it is there, and is not a file");
}

// The tests run as the user nobody while it exists, if they run as root, who may read whatever there is.
struct NotRoot {
    uid_t user = geteuid();
    NotRoot() {
        constexpr uid_t nobody = 65534;
        if (user == 0) {
            EXPECT_EQ(seteuid(nobody), 0);
        }
    }
    ~NotRoot() { EXPECT_EQ(seteuid(user), 0); }
    NotRoot(const NotRoot&) = delete;
    NotRoot& operator=(const NotRoot&) = delete;
};

TEST_F(SnapshotFile, SaysThatItMayNotBeRead) {
    write("text", "Lorem ipsum dolor sit amet");
    std::filesystem::permissions(folder / "text", std::filesystem::perms::none);
    const NotRoot notRoot;
    std::error_code closed;
    if (!std::filesystem::exists(folder / "text", closed))
        GTEST_SKIP() << folder << " lies where the user nobody may not look";
    EXPECT_SAYS(readSnapshot(folder / "text"), "may you read it?");
}

}  // namespace
}  // namespace drench::snapshot_refusal_test
