// Runs a scene in a window.
#pragma once

#include <chrono>
#include <filesystem>
#include <iosfwd>
#include <memory>
#include <string>

#include "run/recorder.h"
#include "run/run_options.h"
#include "run/simulation.h"
#include "viewer/renderer.h"
#include "viewer/window.h"
#include "window/panel.h"

namespace drench::demo {

// Counts the pictures of a window, for the output of --timings.
class PictureCount {
  public:
    using Clock = std::chrono::steady_clock;

    // @param start  of the program
    explicit PictureCount(Clock::time_point start) : start_(start) {}

    // Registers that a picture is on the screen.
    void note();
    // Writes when the first picture appeared, and the frame rate after that.
    void report(std::ostream& out) const;

  private:
    Clock::time_point start_;
    Clock::time_point first_;
    Clock::time_point last_;
    int count_ = 0;
};

// Shows a simulation, which runs on its own thread, and passes user input to it. It draws the latest frame
// state; drawing delays the simulation only for pictures and videos that must be complete.
class WindowRun {
  public:
    // Opens the window. @throws std::runtime_error if that fails
    explicit WindowRun(const RunOptions& options);

    // Runs until the window is closed. @return the exit status: 0, 1 after OpenGL errors, or 2 if a video or
    // the scene has failed
    int loop();

  private:
    void see();
    void stepBack(bool wasSplit, bool isSplit);
    void obeyKeys();
    void obey(viewer::Key key);
    void useMouse();
    void draw();
    void keepPictures();
    void keep(const Keepsake& keepsake);
    void startFilm(const std::filesystem::path& file);
    void endFilm();
    void loseFilm(const std::string& why);
    void write(const std::filesystem::path& file, const viewer::Image& image);
    std::filesystem::path pictureFolder() const;
    void takeScreenshot();
    void restart();
    const viewer::Picture& pictureUnder(const viewer::Mouse& mouse) const;
    viewer::Picture seen(viewer::Picture picture);
    viewer::Image imageOf(const FrameState& state);
    int exitStatus() const;

    RunOptions options_;
    PanelState state_;
    viewer::Window window_;
    Simulation simulation_;  // makes its scene while the renderer compiles its shaders
    viewer::Renderer renderer_;
    Panel panel_;
    PictureCount pictures_;
    std::shared_ptr<const FrameState> latest_;  // the latest one
    std::string cameraOf_;                      // scene for which the camera was set
    bool onCloth_ = false;                      // whether the left button was pressed on cloth
    std::unique_ptr<Recorder> film_;
    std::filesystem::path filmFile_;
    bool filmLost_ = false;
};

// Makes the scene that the options name and runs it in a window until that is closed.
// @return the exit status, as `WindowRun::loop`
int runInWindow(const RunOptions& options);

}  // namespace drench::demo
