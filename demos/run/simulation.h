// A scene that runs by itself, on a thread of its own.
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

// A frame that somebody wants to have drawn, however slowly that goes.
struct Keepsake {
    std::shared_ptr<const FrameState> state;
    std::string name;     // of its picture, without folder and ending; empty: none is wanted
    bool filmed = false;  // part of the film
};

// Owns a scene and steps it, no faster than 60 frames a second of wall time unless told so. What the user
// does is applied between two frames. Nobody who looks on makes it wait, except for pictures that have to be
// kept.
//
// What goes wrong on the thread stops the scene, and stands in the frame state's `trouble` and on stderr; a
// restart begins anew. All calls are for the thread that made it, and none waits for a frame but the
// destructor.
class Simulation {
  public:
    using Command = std::function<void(Scene&)>;
    using Now = std::function<FrameClock::Clock::time_point()>;

    // Starts the thread.
    // @param request  its scene is made on the thread
    // @param options  what to write; the CSV comes at the end of each run, pictures by `takeKeepsakes`
    // @param now  the wall time that frames keep to; called on the thread, too
    Simulation(SceneRequest request, const RunOptions& options, Now now = FrameClock::Clock::now);
    // Waits for the frame under way.
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    // Begins a new run; commands that still wait are dropped.
    void restart(SceneRequest request);
    // Does something to the scene, and to its dry twin, before the next frame; commands keep their order.
    // What they throw stands in the frame states' `notice`, and the scene goes on.
    void post(Command command);
    // Where the mouse is and what it does, until told otherwise.
    void setPointer(const Pointer& pointer);

    // Lets it stand still, or go on.
    void setPaused(bool paused);
    // Whether it stands still; default: as the options say.
    bool paused() const;
    // Simulates one frame more, also while it stands still.
    void step();
    // Simulated time over wall time, at most; 0: as fast as it can. Default 1.
    void setSpeed(double speed);
    double speed() const;

    // Shows the sheets in this way from now on.
    void setView(View view);
    // Writes the scene as it is after the frame under way into a scene file; the frame states' `notice` says
    // how that went.
    void save(const std::filesystem::path& file);
    // How long the window has taken to draw a picture, s, for scenes that report it.
    void noteDrawTime(double seconds);

    // The newest frame state; none before the first scene is made.
    std::shared_ptr<const FrameState> latest() const;
    // Whether each frame from now on is kept for a film; the simulation then waits for whoever takes them.
    void setFilmed(bool filmed);
    // Hands over the frames to be drawn since the last call, oldest first.
    std::vector<Keepsake> takeKeepsakes();

  private:
    // What the thread is to do next.
    struct Orders {
        SceneRequest request;
        std::deque<Command> commands;
        Pointer pointer;
        View view = View::beauty;
        std::optional<double> drawTime;  // s
        bool frame = false;
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

    mutable std::mutex mutex_;  // of what follows, up to the thread's own
    std::condition_variable news_;
    Orders orders_;
    bool stop_ = false;
    bool paused_;
    bool standsStill_ = true;  // before the first scene, and after trouble
    int steps_ = 0;            // to make in spite of a pause
    double speed_ = 1;
    FrameClock clock_;
    std::shared_ptr<const FrameState> latest_;
    std::deque<Keepsake> keepsakes_;

    // Of the thread alone.
    std::unique_ptr<SceneRun> run_;
    int runs_ = 0;
    std::string notice_;
    FrameClock::Clock::time_point published_;

    std::thread thread_;  // last, as it uses all of the above
};

}  // namespace drench::demo
