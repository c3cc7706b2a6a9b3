// A scene that is simulated on its own thread.
#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "hand/pointer.h"
#include "run/frame_clock.h"
#include "run/frame_state.h"
#include "run/run_options.h"
#include "run/scene_run.h"

namespace drench::demo {

// A frame that must be drawn, even if the simulation has to wait.
struct Keepsake {
    std::shared_ptr<const FrameState> state;
    std::string name;     // of its picture, without folder and extension; empty: no picture
    bool filmed = false;  // whether it belongs to the video
};

// Owns a scene and steps it, at up to 60 frames per second of wall time by default. User input is applied
// between two frames. Readers never delay it, except for pictures that must be kept.
//
// An error on the thread stops the scene; it is reported in the frame state's `trouble` and on stderr, and a
// restart begins again. All functions are for the thread that constructed it; only the destructor waits for a
// frame.
class Simulation {
  public:
    using Command = std::function<void(Scene&)>;
    using Now = std::function<FrameClock::Clock::time_point()>;

    // Starts the thread.
    // @param request  its scene is made on the thread
    // @param options  files to write: the CSV at the end of each run, pictures by `takeKeepsakes`
    // @param now  clock of the wall time; called also on the thread
    Simulation(SceneRequest request, const RunOptions& options, Now now = FrameClock::Clock::now);
    // Waits for the current frame.
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    // Starts a new run; pending commands are dropped.
    void restart(SceneRequest request);
    // Applies a function to the scene, and to its dry copy, before the next frame; the order is kept.
    // Exceptions are reported in the frame states' `notice`, and the scene continues.
    void post(Command command);
    // Position and tool of the mouse, valid until changed.
    void setPointer(const Pointer& pointer);

    // Pauses or continues.
    void setPaused(bool paused);
    // Whether it is paused; the default is in the options.
    bool paused() const;
    // Simulates one more frame, also while it is paused.
    void step();
    // Largest ratio of simulated time to wall time; 0: unlimited. Default 1.
    void setSpeed(double speed);
    double speed() const;

    // Sets what pictures show of the sheets from now on.
    void setView(View view);
    // Writes the state after the current frame to a scene file; the result is in the frame states' `notice`.
    void save(const std::filesystem::path& file);
    // Time for drawing a picture in the window, s, for scenes that report it.
    void noteDrawTime(double seconds);

    // The latest frame state; null before the first scene is made.
    std::shared_ptr<const FrameState> latest() const;
    // Whether each frame from now on is kept for a video; the simulation then waits until frames are taken.
    void setFilmed(bool filmed);
    // Returns the frames to be drawn since the last call, oldest first.
    std::vector<Keepsake> takeKeepsakes();

  private:
    // Input for the thread.
    struct Orders {
        SceneRequest request;
        std::deque<Command> commands;
        Pointer pointer;
        View view = View::beauty;
        std::optional<double> drawTime;  // s
        bool frame = false;
        bool single = false;  // a frame in spite of a pause
        bool filmed = false;
    };

    template <typename Change>
    void change(Change change);
    void work();
    bool waitForWork(std::unique_lock<std::mutex>& lock);
    bool wantsFrame() const;
    Orders takeOrders();
    void carryOut(const Orders& orders);
    void publish(const Orders& orders);
    void obey(const Command& command);
    void fail(const std::string& what);

    const RunOptions options_;
    const Now now_;

    mutable std::mutex mutex_;  // for the members down to those of the thread
    std::condition_variable news_;
    Orders orders_;
    bool stop_ = false;
    bool paused_;
    bool standsStill_ = true;  // before the first scene, and after an error
    int steps_ = 0;            // frames to simulate in spite of a pause
    double speed_ = 1;
    FrameClock clock_;
    std::shared_ptr<const FrameState> latest_;
    std::deque<Keepsake> keepsakes_;

    // Used only by the thread.
    std::unique_ptr<SceneRun> run_;
    int runs_ = 0;
    std::string notice_;
    FrameClock::Clock::time_point published_;

    std::thread thread_;  // last, because it uses all members above
};

}  // namespace drench::demo
