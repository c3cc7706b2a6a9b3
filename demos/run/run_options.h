// The command line of drench-demo.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "stage/scene.h"

namespace drench::demo {

constexpr int pictureWidth = 1280, pictureHeight = 720;  // of pictures and films, pixels

// The scene and how to run it.
struct RunOptions {
    std::string scene;                          // a built-in name, or that of the scene file
    std::optional<SceneDescription> described;  // contents of the scene file; none: a built-in scene
    SceneOptions sceneOptions;
    bool headless = false;
    std::filesystem::path csv;     // empty: no file
    std::filesystem::path saved;   // scene file for the state at the end; empty: none
    View view = View::beauty;      // what pictures show of the sheets, initially in the window
    std::filesystem::path frames;  // folder for pictures; empty: none
    std::pair<int, int> windowSize{pictureWidth, pictureHeight};  // in screen coordinates
    double speed = 1;        // in the window, largest ratio of simulated time to wall time; 0: unlimited
    bool paused = false;     // starts the window with the scene paused
    bool quitAtEnd = false;  // closes the window when the scene ends
    std::filesystem::path record;    // video to record; empty: none
    std::filesystem::path exported;  // export of the sheets: .glb, .obj or .csv; empty: none
    bool timings = false;            // prints when the first picture appeared, and the frame rate
    std::chrono::steady_clock::time_point started = std::chrono::steady_clock::now();  // start of the program
    int every = 0;  // number of frames between pictures; 0: chosen by the scene
};

// The options of the command line, or the exit status if the program must end at once: 0 after --help or
// --list, 2 for invalid arguments, with the reason on stderr.
struct ParsedOptions {
    RunOptions options;
    std::optional<int> exitStatus;
};

ParsedOptions parseOptions(int argc, char** argv);

}  // namespace drench::demo
