// A scene on a thread of its own.
#include "run/simulation.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "description/scene_file.h"
#include "scenes/described_scene.h"
#include "scenes/registry.h"
#include "stage/stage.h"

namespace drench::demo::simulation_test {
namespace {

using std::chrono::steady_clock;

SceneDescription hangingSheet() {
    SceneDescription scene;
    scene.name = "hanging";
    scene.duration = 1;
    SheetDescription sheet;
    sheet.nodes = {12, 12};
    sheet.pins = {{0, 0}, {-1, 0}};
    sheet.saturation = 1.3;
    scene.sheets.push_back(sheet);
    return scene;
}

SceneRequest request(const SceneDescription& description = hangingSheet()) {
    return {description.name,
            [description] {
                SceneOptions options;
                options.fabric.clear();
                return makeScene(description, options);
            },
            nullptr};
}

// Waits; ten minutes mean never.
bool comesTrue(const std::function<bool()>& condition) {
    const auto until = steady_clock::now() + std::chrono::minutes(10);
    while (!condition()) {
        if (steady_clock::now() > until) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
}

bool reaches(const Simulation& simulation, int frame) {
    return comesTrue([&] { return simulation.latest() && simulation.latest()->frame >= frame; });
}

// A clock that goes on when told.
class Clock {
  public:
    void advance(double seconds) { nanoseconds_ += std::llround(1e9 * seconds); }
    Simulation::Now now() {
        return [this] { return FrameClock::Clock::time_point(std::chrono::nanoseconds(nanoseconds_)); };
    }

  private:
    std::atomic<std::int64_t> nanoseconds_{0};
};

// Has the simulation do something between frames, and waits until it is seen; it then has had its chance of a frame.
void goRound(Simulation& simulation) {
    const auto done = std::make_shared<std::atomic<bool>>(false);
    simulation.post([done](Scene&) { *done = true; });
    ASSERT_TRUE(comesTrue([&] { return done->load(); }));
}

TEST(Simulation, RunsByItselfNoFasterThanTheClock) {
    Clock clock;
    RunOptions options;
    options.record = "film";  // hands over each frame
    Simulation simulation(request(), options, clock.now());
    int frames = 0;
    const auto count = [&] { return frames += int(simulation.takeKeepsakes().size()); };
    constexpr double frameTime = Scene::frameTime, early = 1e-3, rounding = 1e-9;  // s
    for (int frame = 1; frame <= 10; ++frame) {
        ASSERT_TRUE(comesTrue([&] { return count() >= frame; }));
        clock.advance(frameTime - early);
        EXPECT_EQ(count(), frame);
        clock.advance(early + rounding);
    }
    ASSERT_TRUE(comesTrue([&] { return count() >= 11; }));
    clock.advance(10);
    ASSERT_TRUE(comesTrue([&] { return count() >= 13; }));
    clock.advance(frameTime + rounding);
    ASSERT_TRUE(comesTrue([&] { return count() >= 14; }));
    EXPECT_EQ(count(), 14) << "of what comes late only one frame is made up for";
    const auto snapshot = simulation.latest();
    EXPECT_EQ(snapshot->scene, "hanging");
    EXPECT_EQ(snapshot->sheets.size(), 1u);
    EXPECT_EQ(snapshot->picture.sheets.size(), 1u);
    EXPECT_GT(snapshot->times.all, 0);
    EXPECT_TRUE(snapshot->trouble.empty());
}

TEST(Simulation, RunsAsFastAsItCanWhenTold) {
    Clock clock;
    Simulation simulation(request(), {}, clock.now());
    simulation.setSpeed(0);
    clock.advance(0.017);  // until the frame that was due at the speed before
    EXPECT_TRUE(reaches(simulation, 100));
}

TEST(Simulation, StandsStillAndStepsOnce) {
    Simulation simulation(request(), {});
    simulation.setSpeed(0);
    simulation.setPaused(true);
    ASSERT_TRUE(comesTrue([&] { return simulation.latest() != nullptr; }));
    goRound(simulation);
    const int frame = simulation.latest()->frame;
    for (int i = 0; i < 20; ++i) goRound(simulation);
    EXPECT_EQ(simulation.latest()->frame, frame);
    simulation.step();
    EXPECT_TRUE(comesTrue([&] {
        goRound(simulation);
        return simulation.latest()->frame > frame;
    }));
    for (int i = 0; i < 20; ++i) goRound(simulation);
    EXPECT_EQ(simulation.latest()->frame, frame + 1);
    simulation.step();
    EXPECT_TRUE(reaches(simulation, frame + 2))
        << "a step is shown however soon it comes after another picture";
}

TEST(Simulation, BeginsPausedWhenTheOptionsSaySo) {
    RunOptions options;
    options.paused = true;
    Simulation simulation(request(), options);
    ASSERT_TRUE(comesTrue([&] { return simulation.latest() != nullptr; }));
    for (int i = 0; i < 20; ++i) goRound(simulation);
    EXPECT_TRUE(simulation.paused());
    EXPECT_EQ(simulation.latest()->frame, 0);
    simulation.setPaused(false);
    EXPECT_TRUE(reaches(simulation, 2));
}

TEST(Simulation, DoesWhatIsPostedInOrderAlsoWhileItStandsStill) {
    Simulation simulation(request(), {});
    simulation.setPaused(true);
    simulation.post([](Scene& scene) { scene.stages()[0]->weather().windSpeed = 3; });
    simulation.post([](Scene& scene) { scene.stages()[0]->weather().windSpeed *= 2; });
    EXPECT_TRUE(comesTrue([&] {
        const auto snapshot = simulation.latest();
        return snapshot && snapshot->weather && snapshot->weather->windSpeed == 6;
    }));
}

TEST(Simulation, TellsOfTroubleAndBeginsAnew) {
    Simulation simulation(request(), {});
    simulation.post([](Scene& scene) { scene.stages()[0]->weather().temperature = 1e6; });
    ASSERT_TRUE(comesTrue([&] {
        const auto snapshot = simulation.latest();
        return snapshot && !snapshot->trouble.empty();
    }));
    EXPECT_NE(simulation.latest()->trouble.find("temperature"), std::string::npos);
    const int run = simulation.latest()->run;
    simulation.restart(request());
    EXPECT_TRUE(comesTrue([&] {
        const auto snapshot = simulation.latest();
        return snapshot->trouble.empty() && snapshot->run == run + 1 && snapshot->frame > 5;
    }));
}

TEST(Simulation, GoesOnAfterACommandThatFails) {
    Simulation simulation(request(), {});
    simulation.post([](Scene&) { throw std::runtime_error("the disk is full"); });
    ASSERT_TRUE(comesTrue([&] {
        const auto snapshot = simulation.latest();
        return snapshot && snapshot->notice == "the disk is full";
    }));
    EXPECT_TRUE(reaches(simulation, simulation.latest()->frame + 5));
    EXPECT_TRUE(simulation.latest()->trouble.empty());
}

TEST(Simulation, HasADryTwinOfItsOwn) {
    SceneRequest both = request();
    both.makeTwin = [] {
        SceneOptions options;
        options.fabric.clear();
        options.water = false;
        return makeScene(hangingSheet(), options);
    };
    Simulation simulation(both, {});
    ASSERT_TRUE(reaches(simulation, 20));
    const auto snapshot = simulation.latest();
    ASSERT_TRUE(snapshot->dryPicture.has_value());
    EXPECT_LT(snapshot->picture.sheets[0].albedo[50].x(),
              0.95f * snapshot->dryPicture->sheets[0].albedo[50].x());
}

TEST(Simulation, SavesTheSceneAsItIs) {
    const auto file = std::filesystem::temp_directory_path() / "drench-simulation-test.json";
    Simulation simulation(request(), {});
    ASSERT_TRUE(reaches(simulation, 10));
    simulation.save(file);
    ASSERT_TRUE(comesTrue([&] { return simulation.latest()->notice == "wrote " + file.string(); }));
    const SceneDescription saved = loadScene(file);
    EXPECT_EQ(saved.name, "hanging");
    EXPECT_GT(saved.time, 9 * Scene::frameTime);
    ASSERT_EQ(saved.sheets.size(), 1u);
    EXPECT_TRUE(saved.sheets[0].state.has_value());
    simulation.save("/proc/no/such.json");
    EXPECT_TRUE(comesTrue(
        [&] { return simulation.latest()->notice.find("/proc/no/such.json") != std::string::npos; }));
    std::filesystem::remove(file);
}

TEST(Simulation, TellsWhyASceneCannotBeMade) {
    Simulation simulation(
        {"none", []() -> std::unique_ptr<Scene> { throw std::invalid_argument("no cloth"); }, nullptr}, {});
    EXPECT_TRUE(comesTrue([&] {
        const auto snapshot = simulation.latest();
        return snapshot && snapshot->trouble == "no cloth";
    }));
    simulation.restart(request());
    EXPECT_TRUE(reaches(simulation, 2));
}

TEST(Simulation, WaitsForAFilmAndSkipsNoFrame) {
    Simulation simulation(request(), {});
    simulation.setSpeed(0);
    simulation.setFilmed(true);
    constexpr int atATime = 3;  // frames that may wait to be drawn
    int last = -1;
    for (int seen = 0; seen < 40;) {
        ASSERT_TRUE(reaches(simulation, last + atATime));
        if (last >= 0) {
            EXPECT_EQ(simulation.latest()->frame, last + atATime) << "it has not waited";
        }
        for (const Keepsake& keepsake : simulation.takeKeepsakes()) {
            EXPECT_TRUE(keepsake.filmed);
            if (last >= 0) {
                EXPECT_EQ(keepsake.state->frame, last + 1);
            }
            last = keepsake.state->frame;
            ++seen;
        }
    }
}

TEST(Simulation, PlaysOnAfterTheEndOfTheScene) {
    testing::internal::CaptureStdout();
    Simulation simulation(request(), {});
    simulation.setSpeed(0);
    EXPECT_TRUE(reaches(simulation, 90));
    EXPECT_TRUE(simulation.latest()->ended);
    EXPECT_NE(testing::internal::GetCapturedStdout(), "");
}

// At any moment: nothing is done out of turn, and nothing once it has ended, and nothing of what it was given is kept.
TEST(Simulation, EndsInTheMidstOfEverything) {
    for (int i = 0; i < 20; ++i) {
        const auto done = std::make_shared<std::vector<int>>();
        {
            Simulation simulation(request(), {});
            Pointer pointer;
            pointer.pressed = true;
            pointer.ray = {{0, 1, 3}, {0, 0, -1}};
            simulation.setPointer(pointer);
            if (i % 3 == 0) simulation.setPaused(true);
            if (i % 4 == 0) simulation.restart(request());
            for (int k = 0; k < i; ++k)
                simulation.post([done, k](Scene& scene) {
                    scene.sheets()[0].cloth->soakFilm(0.01);
                    done->push_back(k);
                });
            if (i % 2 == 0) goRound(simulation);
            if (i % 5 == 0 && i % 3 != 0) {
                EXPECT_TRUE(reaches(simulation, i));
            }
        }
        EXPECT_EQ(done.use_count(), 1);
        EXPECT_TRUE(i % 2 != 0 || int(done->size()) == i) << i;
        for (std::size_t k = 0; k < done->size(); ++k) EXPECT_EQ((*done)[k], int(k)) << i;
    }
}

}  // namespace
}  // namespace drench::demo::simulation_test
